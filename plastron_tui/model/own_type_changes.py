"""What follows when a type of the program becomes another one: circles, and uses that break."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any, TypeAlias

from plastron_tui.diagnostics import Diagnostic, Label, Span, codes
from plastron_tui.language import statements as st
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.ros.type_circles import find_circle

from .field_lines import written_type
from .mistake import Mistake
from .own_type_values import fit_anew
from .own_types import Definition, OwnType, interfaces_of
from .run import Run
from .type_members import nested_names

Make: TypeAlias = Callable[[int], Definition | list[Diagnostic]]
"""Makes what a type is in a generation of ROS, or says what is wrong there."""


def settle(run: Run, statement: Any, own: OwnType, make: Make, variable: str | None = None) -> None:
    """Let a type mean in each generation of ROS what it is there now.

    What is wrong in the generation that the program is for is told here; in the other one, where
    a node of it uses the type.
    """
    first = run.checks.version(None)
    others = run.messages.other_versions()
    definitions: dict[int, Definition] = {}
    wrong: dict[int, list[Diagnostic]] = {}
    for version in (first, 3 - first):
        if own.definitions and version not in own.definitions:
            wrong[version] = [own.wrong[version]]
            continue
        made = make(version)
        if isinstance(made, list):
            wrong[version] = made
        else:
            definitions[version] = made
    if first in wrong and not (definitions and others):
        raise Mistake(*wrong[first])
    kept = {version: found[0] for version, found in wrong.items() if found}
    changed = own.with_definitions(definitions, kept)
    types, key = run.workspace.types, variable or own.name
    before = types.get(key)
    types[key] = changed
    try:
        run.types.changed()
        for version in definitions:
            _check_circle(run, statement, changed, version)
        if before is not None:
            broken = fit_anew(run)
            if broken:
                raise in_use(statement, own, broken)
    except Mistake:
        if before is None:
            del types[key]
        else:
            types[key] = before
        run.types.changed()
        raise


def _check_circle(run: Run, statement: Any, own: OwnType, version: int) -> None:
    package = run.types.own_package(version)
    interfaces = interfaces_of(run.workspace.types.values(), version, package)
    messages = {
        name: each for (kind, name), each in interfaces.items() if kind is InterfaceKind.MESSAGE
    }
    circle = find_circle(messages)
    if circle:
        names = [each.name for each in circle]
        shown = " in ".join(f"`{each}`" for each in (*names, names[0]))
        match statement:
            case st.HasField():
                where = written_type(statement)
            case st.LoadType():
                where = statement.span_of("source")
            case _:
                where = statement.span_of("type")
        message = f"`{names[0]}` contains itself: {shown}"
        if len(names) == 1:
            message = f"`{names[0]}` contains itself"
        raise Mistake(Diagnostic(codes.CIRCULAR_TYPE, message, where))


def users_of(run: Run, own: OwnType) -> Iterator[Span]:
    """Yield the statements that use a type."""
    names = {each.interface.name for each in own.definitions.values()}
    for node in run.workspace.nodes.values():
        for endpoint in node.endpoints.values():
            if endpoint.type in names and endpoint.span is not None:
                yield endpoint.span
    for message in run.workspace.messages.values():
        if message.value.type in names:
            yield message.span
    for other in run.workspace.types.values():
        sections = (
            section for each in other.definitions.values() for section in each.interface.sections
        )
        if other is not own and any(names & nested_names(section) for section in sections):
            yield other.span


def in_use(statement: Any, own: OwnType, users: Sequence[Span]) -> Mistake:
    """Make the mistake of a change that what uses a type does not bear."""
    message = f"something of the program uses `{own.name}` as it is"
    return Mistake(
        Diagnostic(
            codes.TYPE_IN_USE,
            message,
            statement.span,
            help="change first what uses it",
            labels=tuple(Label(span, "used here") for span in users[:5]),
        )
    )
