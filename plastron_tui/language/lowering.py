"""From the tree to statements."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from enum import Enum, auto
from itertools import pairwise
from typing import Any, NamedTuple

from tree_sitter import Node

from plastron_tui.diagnostics import Diagnostic, Span, codes

from . import statements as _statements  # noqa: F401 - declares the statements
from .broken_lines import Broken
from .declaration import DECLARATIONS, Declaration, Form, Statement
from .document import Document
from .grammar import field_id, kind_id
from .inputs import COMMENTS, DEEPEST_NESTING, TooDeep, lower_input, lower_number


class Program(NamedTuple):
    """The statements of a text, in order, and what kept the rest from being statements.

    `broken` is what the other lines were to do: the statements may rely on it.
    """

    statements: tuple[Statement, ...]
    diagnostics: tuple[Diagnostic, ...] = ()
    broken: Broken = Broken()


class _Lowered(Enum):
    """How the text of a slot becomes its value."""

    TEXT = auto()
    QUOTED = auto()
    FILE = auto()
    NUMBER = auto()
    INPUT = auto()


# Looking a member up in its class costs as much as lowering a word.
_TEXT, _QUOTED, _INPUT = _Lowered.TEXT, _Lowered.QUOTED, _Lowered.INPUT

_BY_FORM = {
    Form.QUOTED: _Lowered.QUOTED,
    Form.NUMBER: _Lowered.NUMBER,
    Form.VALUES: _Lowered.INPUT,
    Form.FILE: _Lowered.FILE,
}

_NO_LINE_END = re.compile(rb"(?:[^\S\n]|\xef\xbb\xbf|/\*(?:[^*]|\*(?!/))*\*/)*")
"""Space and comments that leave what follows on the line of what they follow."""

_Plan = tuple[Callable[..., Statement], tuple[tuple[int, _Lowered], ...]]


def _plan(declaration: Declaration) -> _Plan:
    return declaration.type, tuple(
        (field_id(slot.name), _BY_FORM.get(slot.kind.form, _Lowered.TEXT))
        for slot in declaration.slots
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
                found.append(_lower_statement(node, plan, source))
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
    for field in ("variable", "node", "service"):
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


def _lower_statement(node: Node, plan: _Plan, source: bytes) -> Statement:
    make, slots = plan
    values: list[Any] = [Span(node.start_byte, node.end_byte), node]
    for field, how in slots:
        child = node.child_by_field_id(field)
        if child is None:
            values.append(None)
        elif how is _TEXT:
            values.append(source[child.start_byte : child.end_byte].decode())
        elif how is _QUOTED:
            values.append(source[child.start_byte + 1 : child.end_byte - 1].decode())
        elif how is _INPUT:
            values.append(lower_input(child, source))
        elif how is _Lowered.NUMBER:
            values.append(lower_number(source[child.start_byte : child.end_byte]))
        else:
            written = source[child.start_byte : child.end_byte].decode()
            values.append(written[1:-1] if child.type == "path" else written)
    return make(*values)
