"""From the tree to statements."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise
from typing import Any, NamedTuple

from tree_sitter import Node

from plastron_tui.diagnostics import Diagnostic, Span, codes

from . import statements as _statements  # noqa: F401 - declares the statements
from .broken_lines import Broken
from .declaration import DECLARATIONS, Clause, Declaration, Form, SlotKind, Statement
from .definitions import lower_fields, lower_remaps, lower_settings, lower_vector
from .document import Document
from .grammar import field_id, kind_id
from .inputs import (
    COMMENTS,
    DEEPEST_NESTING,
    Nothing,
    TooDeep,
    lower_condition,
    lower_input,
    lower_number,
    lower_qos,
    lower_rate,
    lower_text,
    lower_value,
)


class Program(NamedTuple):
    """The statements of a text, in order, and what kept the rest from being statements.

    `broken` is what the other lines were to do: the statements may rely on it.
    """

    statements: tuple[Statement, ...]
    diagnostics: tuple[Diagnostic, ...] = ()
    broken: Broken = Broken()


_Lower = Callable[[Node, bytes], Any]


def _word(node: Node, source: bytes) -> str:
    return source[node.start_byte : node.end_byte].decode()


def _quoted(node: Node, source: bytes) -> str:
    return source[node.start_byte + 1 : node.end_byte - 1].decode()


def _file(node: Node, source: bytes) -> str:
    return _quoted(node, source) if node.type == "path" else _word(node, source)


def _color(node: Node, source: bytes) -> str:
    return lower_text(node, source) if node.type == "string" else _word(node, source)


def _or_none(lower_: _Lower) -> _Lower:
    return lambda node, source: Nothing.NONE if node.type == "none" else lower_(node, source)


_BY_FORM: dict[Form, _Lower] = {
    Form.QUOTED: _quoted,
    Form.NUMBER: lambda node, source: lower_number(source[node.start_byte : node.end_byte]),
    Form.VALUES: lower_input,
    Form.VALUE: lower_value,
    Form.FILE: _file,
    Form.RATE: lower_rate,
    Form.TEXT: lower_text,
    Form.FLAG: lambda node, source: True,
    Form.QOS: lower_qos,
    Form.CONDITION: lower_condition,
    Form.FIELDS: lower_fields,
    Form.REMAPS: lower_remaps,
    Form.SETTINGS: lower_settings,
    Form.VECTOR: lower_vector,
    Form.COLOR: _color,
}
"""How what is in a slot becomes its value; of the other forms it is the text."""

_NO_LINE_END = re.compile(rb"(?:[^\S\n]|\xef\xbb\xbf|/\*(?:[^*]|\*(?!/))*\*/)*")
"""Space and comments that leave what follows on the line of what they follow."""


class _Plan(NamedTuple):
    """How a statement is lowered.

    Attributes:
        make: makes it of its place, its syntax and the values of its slots.
        slots: the grammar's field of each slot, how it is lowered, and what stands for none.
        words: how many words and slots it has without its clauses.
        clauses: the position of the first slot of each clause, how many words and slots the
            clause has, and its bracket.
    """

    make: Callable[..., Statement]
    slots: tuple[tuple[int, _Lower, Any], ...]
    words: int
    clauses: tuple[tuple[int, int, int], ...]


def _lower_of(kind: SlotKind) -> _Lower:
    """Return how what is in a slot becomes its value; values and fields know of none."""
    lower_ = _BY_FORM.get(kind.form, _word)
    return _or_none(lower_) if kind.may_be_none and not kind.form.is_open else lower_


def _plan(declaration: Declaration) -> _Plan:
    slots = declaration.slots
    return _Plan(
        declaration.type,
        tuple(
            (
                field_id(slot.name),
                _lower_of(slot.kind),
                False if slot.kind.form is Form.FLAG else None,
            )
            for slot in slots
        ),
        sum(not isinstance(element, Clause) for element in declaration.elements),
        tuple(
            (
                2 + slots.index(next(clause.slots)),
                sum(not isinstance(part, Clause) for part in clause.elements),
                clause.bracket,
            )
            for clause in declaration.clauses
        ),
    )


_PLANS: dict[int, _Plan] = {
    kind_id(declaration.kind): _plan(declaration) for declaration in DECLARATIONS.values()
}


def lower(document: Document) -> Program:
    """Turn the tree of a document into statements and diagnostics.

    A line that does not parse gives one diagnostic and no statement.
    """
    source = document.text
    root = document.tree.root_node
    found: list[Statement] = []
    broken: list[Node] = []
    too_deep: list[Diagnostic] = []
    unread: set[str] = set()
    for node in _flattened(root) if root.has_error else root.children:
        plan = _PLANS.get(node.kind_id)
        if plan is not None and not node.has_error:
            try:
                statement = _lower_statement(node, plan, source)
                if statement is None:
                    broken.append(node)
                else:
                    found.append(statement)
            except TooDeep as problem:
                too_deep.append(_too_deep(problem.syntax))
                unread.update(_variables(node, source))
        elif node.kind_id not in COMMENTS:
            broken.append(node)
    if not broken:
        lost = frozenset(unread)
        return Program(tuple(found), tuple(too_deep), Broken(lost, lost))
    whole, broken = _apart(source, found, broken)
    from .syntax_errors import explain  # a program without mistakes does not need it

    diagnostics, what = explain(source, broken)
    what = what._replace(words=what.words | unread, declared=what.declared | unread)
    return Program(tuple(whole), (*diagnostics, *too_deep), what)


def is_right(root: Node, source: bytes) -> bool:
    """Tell whether a line is one statement, or only a comment, without a mistake.

    Args:
        root: the tree of the line alone.
        source: the line.
    """
    if root.has_error:
        return False
    nodes = [node for node in root.children if node.kind_id not in COMMENTS]
    if len(nodes) != 1:
        return not nodes
    plan = _PLANS.get(nodes[0].kind_id)
    try:
        return plan is not None and _lower_statement(nodes[0], plan, source) is not None
    except TooDeep:
        return False


def _apart(
    source: bytes, found: Sequence[Statement], broken: Sequence[Node]
) -> tuple[list[Statement], list[Node]]:
    """Return the statements that have their lines to themselves, and what stands on other lines.

    A statement with something else on its line is not what its writer meant.
    """
    rows = {row for node in broken for row in _rows(node)}
    rows.update(_rows_of_two(source, found))
    whole = []
    rest = list(broken)
    for statement in found:
        if rows.isdisjoint(_rows(statement.syntax)):
            whole.append(statement)
        else:
            rest.append(statement.syntax)
    rest.sort(key=lambda node: node.start_byte)
    return whole, rest


def _too_deep(syntax: Node) -> Diagnostic:
    return Diagnostic(
        codes.TOO_DEEP,
        f"values are nested at most {DEEPEST_NESTING} deep",
        Span(syntax.start_byte, syntax.start_byte + 1),
    )


def _variables(node: Node, source: bytes) -> Iterator[str]:
    """Yield what a statement that has no effect names: variables, and names without quotes."""
    owners = ("node", "package", "launch", "robot")
    for field in ("variable", "service", "type", "item", *owners):
        child = node.child_by_field_name(field)
        if child is not None:
            yield source[child.start_byte : child.end_byte].decode().strip("'")


def _rows(node: Node) -> range:
    return range(node.start_point.row, node.end_point.row + 1)


def _rows_of_two(source: bytes, statements: Sequence[Statement]) -> Iterator[int]:
    """Yield the rows that a statement starts on while another one has not ended its line.

    Mostly the tree lacks a newline between the two. Within an error it need not say so.
    """
    for one, other in pairwise(statements):
        if _NO_LINE_END.fullmatch(source, one.span.end, other.span.start):
            yield other.syntax.start_point.row


def _flattened(root: Node) -> Iterator[Node]:
    """Yield what stands at the top level, and the statements that recovery put into an error."""
    for node in root.children:
        if node.is_error and any(child.kind_id in _PLANS for child in node.children):
            yield from node.children
        else:
            yield node


def _lower_statement(node: Node, plan: _Plan, source: bytes) -> Statement | None:
    """Return a statement, None where a clause stands twice, or beside one that excludes it."""
    values: list[Any] = [Span(node.start_byte, node.end_byte), node]
    for field, lower_, none in plan.slots:
        child = node.child_by_field_id(field)
        values.append(none if child is None else lower_(child, source))
    if plan.clauses and not _is_once(node, plan, values):
        return None
    return plan.make(*values)


def _is_once(node: Node, plan: _Plan, values: list[Any]) -> bool:
    """Tell whether each clause stands once, and none beside one that excludes it."""
    there = [each for each in plan.clauses if values[each[0]] is not plan.slots[each[0] - 2][2]]
    if len({bracket for _, _, bracket in there}) < len(there):
        return False
    count = node.child_count
    if count == plan.words + sum(length for _, length, _ in there):
        return True
    # There is more: a clause, or comments.
    return count - plan.words - sum(length for _, length, _ in there) == sum(
        child.kind_id in COMMENTS for child in node.children
    )
