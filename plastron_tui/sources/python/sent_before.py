"""What a file publishes, and what of that goes where something else is published."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.model.kinds import Publisher
from plastron_tui.sources.written_anew import no_longer_decides, no_longer_sends

from .analysis import Analysis, Site
from .creation import Removal, line_of, remove_creation
from .lost import is_computed
from .references import Reference, Use, Variable, identifiers, references
from .same_message import Interfaces, is_message
from .syntax import parts_of


class Sent(NamedTuple):
    """A message on its way out: the expression, its statements, whether a line stamps it."""

    reference: Reference
    expression: Node
    statements: tuple[Node, ...]
    is_stamped: bool = False


def publishing_on(analysis: Analysis, variable: Variable) -> list[Reference]:
    """Return the statements that publish on a variable."""
    return [each for each in references(variable, analysis) if each.use is Use.PUBLISH]


def lost_sending(
    analysis: Analysis,
    variable: Variable,
    new: Publisher,
    old: str,
    interfaces: Interfaces,
    *,
    is_in_place: bool,
) -> Iterator[Diagnostic]:
    """Yield what is told of the messages that something else takes the place of.

    Args:
        analysis: the file as it was.
        variable: what holds the publisher.
        new: what publishes instead.
        old: the name of what published.
        interfaces: the interface types.
        is_in_place: whether the same lines go on publishing.
    """
    publishing, values = publishing_on(analysis, variable), new.publications
    gone = [
        analysis.syntax.slice(sent.expression)
        for sent in sent_by(analysis, publishing)
        if is_computed(analysis, sent.expression)
        and not any(
            is_message(analysis, interfaces, sent.expression, each.message.value) for each in values
        )
    ]
    yield from no_longer_sends(gone, new, old)
    if not is_in_place:
        lines = sorted({line_of(each.statement) for each in publishing})
        yield from no_longer_decides(list(map(str, lines)), new, old)


def lost_of_site(
    analysis: Analysis, site: Site, new: Publisher, old: str, interfaces: Interfaces
) -> Iterator[Diagnostic]:
    """Yield what is told of the messages of a call that goes, with the lines that publish."""
    for variable in remove_creation(analysis, site, Removal(sites=[site])):
        yield from lost_sending(analysis, variable, new, old, interfaces, is_in_place=False)


def sent_by(analysis: Analysis, publishing: Sequence[Reference]) -> list[Sent]:
    """Return what statements publish, as far as they say it."""
    given = [
        Sent(each, argument, (each.statement,))
        for each in publishing
        if each.node.parent is not None
        and (argument := only_argument(each.node.parent.parent)) is not None
    ]
    named = [_named(analysis, each) for each in given]
    own = [statement for each in named if each is not None for statement in each.statements]
    return [
        plain if each is None or _is_used_elsewhere(analysis, plain.expression, own) else each
        for plain, each in zip(given, named, strict=True)
    ]


def _named(analysis: Analysis, sent: Sent) -> Sent | None:
    """Return a message with the statements before it that make it, None where none do."""
    if sent.expression.type != "identifier":
        return None
    name, statements = analysis.syntax.slice(sent.expression), list(sent.statements)
    before = statements[0].prev_named_sibling
    while before is not None:
        statements.append(before)
        assignment = before.named_children[0] if before.named_children else before
        value = assignment.child_by_field_name("right")
        target = assignment.child_by_field_name("left")
        written = analysis.syntax.slice(target) if target is not None else ""
        if written == name and value is not None and _makes_message(analysis, value):
            return Sent(sent.reference, value, tuple(statements), len(statements) > 2)
        if written != f"{name}.header.stamp":
            return None
        before = before.prev_named_sibling
    return None


def _makes_message(analysis: Analysis, value: Node) -> bool:
    """Whether an expression makes a message, and does nothing besides."""
    callee = value.child_by_field_name("function")
    scope = analysis.scopes.at(value.start_byte)
    return value.type == "call" and analysis.resolver.interface(callee, scope) is not None


def _is_used_elsewhere(analysis: Analysis, variable: Node, statements: Sequence[Node]) -> bool:
    """Whether other statements than the given ones use a variable of the same function."""
    scope = analysis.scopes.at(variable.start_byte)
    return any(
        analysis.scopes.at(node.start_byte).is_within(scope)
        and not any(each.start_byte <= node.start_byte < each.end_byte for each in statements)
        for node in identifiers(analysis.syntax.slice(variable), analysis)
    )


def only_argument(call: Node | None) -> Node | None:
    """Return the argument of a call that has one, and by position."""
    given = parts_of(call.child_by_field_name("arguments")) if call is not None else []
    kinds = ("keyword_argument", "list_splat", "dictionary_splat")
    return given[0] if len(given) == 1 and given[0].type not in kinds else None
