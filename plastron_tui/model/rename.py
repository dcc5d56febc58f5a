"""Giving something of a node another name, with everything else about it as it is."""

from __future__ import annotations

from collections.abc import Iterable

from plastron_tui.diagnostics import Diagnostic, Label, codes, guess
from plastron_tui.language import statements as st
from plastron_tui.ros.names import parameter_name, spelled

from .kinds import EndpointKind, kind_of
from .kinds.needs import rename_uses
from .mistake import Mistake
from .run import Run
from .workspace import Node

RENAMED: dict[str, tuple[EndpointKind, ...]] = {
    word: tuple(kind for kind in EndpointKind if word in (kind.facts.named, kind.word))
    for word in ("topic", "service", "action", "parameter")
}
"""The words of `renames`, and the kinds of endpoints whose names each is for."""


def rename(run: Run, statement: st.Rename) -> None:
    """Give a topic, service, action or parameter of a node another name, on both its sides."""
    node = run.checks.node(statement)
    kinds, version = kinds_of(statement), run.checks.version_of(node)
    new = run.name(statement, "new", version, kinds[0].facts.check_name)
    old = _old_name(statement, node, kinds, version)
    if kinds == (EndpointKind.PARAMETER,) and old not in (statement.old, spelled(statement.old)):
        new = parameter_name(statement.new, version)
    having = kinds_having(run, statement, node, kinds)
    _check_free(run, statement, node, having, new)
    _move(run, statement, node, having, (old, new))
    for kind in having:
        node.rename(kind, old, new, statement.span)
        rename_uses(node, kind, old, new)


def _old_name(
    statement: st.Rename, node: Node, kinds: Iterable[EndpointKind], ros_version: int
) -> str:
    """Return the name that something of a node has.

    A parameter of rclpy has no sign for what is private: `~rate` is its whole name. One of ROS 1
    needs none, as in the statements that give it to a node, where nothing else has the name.
    """
    old = statement.old
    names = {name for kind in kinds for name in node.names(kind)}
    own = parameter_name(old, ros_version) if EndpointKind.PARAMETER in kinds else old
    return next((each for each in (old, spelled(old), own) if each in names), spelled(old))


def _move(
    run: Run, statement: st.Rename, node: Node, kinds: list[EndpointKind], names: tuple[str, str]
) -> None:
    """Let a node use the new name instead of the old one, if that is of the same type to all."""
    version, agreements = run.checks.version_of(node), run.agreements
    old, new = names
    found = (node.by_kind.get(kind, {}).get(old) for kind in kinds)
    typed = [each for each in found if each is not None and each.type is not None]
    for each in typed:
        agreements.leave(node, version, kind_of(type(each)), old)
    named = [each._replace(name=new) for each in typed]
    conflicts = [agreements.join(node, version, each, statement) for each in named]
    conflict = next((each for each in conflicts if each is not None), None)
    if conflict is not None:
        for each in typed:
            agreements.leave(node, version, kind_of(type(each)), new)
            agreements.join(node, version, each, statement)
        raise Mistake(conflict._replace(span=statement.span_of("new"), fix=None))


def kinds_of(statement: st.Rename) -> tuple[EndpointKind, ...]:
    """Return the kinds of endpoints that a statement may rename."""
    kinds = RENAMED.get(statement.what)
    if kinds is not None:
        return kinds
    where = statement.span_of("what")
    remedy, fix = guess(statement.what, RENAMED, where)
    raise Mistake(
        Diagnostic(
            codes.UNKNOWN_NAME_KIND,
            f"`{statement.what}` is nothing that has a name in ROS",
            where,
            help=remedy or f"there are {', '.join(RENAMED)}",
            fix=fix,
        )
    )


def kinds_having(
    run: Run, statement: st.Rename, node: Node, kinds: tuple[EndpointKind, ...]
) -> list[EndpointKind]:
    """Return the kinds of which a node has something of the old name."""
    old = _old_name(statement, node, kinds, run.checks.version_of(node))
    having = [kind for kind in kinds if old in node.names(kind)]
    if having:
        return having
    if run.consequences.explains(node, old):
        raise Mistake
    where = statement.span_of("old")
    names = dict.fromkeys(kind.written(name) for kind in kinds for name in node.names(kind))
    remedy, fix = guess(kinds[0].written(spelled(statement.old)), names, where, is_quoted=True)
    message = f"`{node.variable}` has no {statement.what} `{statement.old}`"
    raise Mistake(Diagnostic(codes.NOTHING_TO_RENAME, message, where, help=remedy, fix=fix))


def _check_free(
    run: Run, statement: st.Rename, node: Node, kinds: list[EndpointKind], new: str
) -> None:
    """Check that a node has nothing of the new name and the same kind."""
    taken = next((kind for kind in kinds if new in node.names(kind)), None)
    if taken is None:
        return
    if run.consequences.explains(node, new):
        raise Mistake
    endpoint = node.by_kind.get(taken, {}).get(new)
    span = None if endpoint is None else endpoint.span
    raise Mistake(
        Diagnostic(
            codes.NAME_TAKEN,
            f"`{node.variable}` {taken.facts.verb} `{new}` already",
            statement.span_of("new"),
            help="one of the two has to get another name, or to go",
            labels=() if span is None else (Label(span, "here"),),
        )
    )
