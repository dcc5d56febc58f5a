"""Whether a part of a function runs each time that the function does."""

from __future__ import annotations

import builtins
from collections.abc import Iterator

from tree_sitter import Node

from plastron_tui.sources.python.references import is_member
from plastron_tui.sources.python.syntax import FUNCTIONS

_EXITS = frozenset({"return_statement", "raise_statement", "continue_statement", "break_statement"})
_PLAIN = frozenset(
    {
        "argument_list", "assignment", "attribute", "await", "block", "call", "else_clause",
        "expression_statement", "keyword_argument", "list", "pattern_list", "expression_list",
        "parenthesized_expression", "tuple", "with_clause", "with_item", "with_statement",
        "try_statement", "finally_clause", "type", "dictionary", "pair", "as_pattern", "if_clause",
        "named_expression", "elif_clause", "return_statement", "subscript", "module",
    }
)  # fmt: skip
_BUILTINS = frozenset(dir(builtins))


def runs_each_time(node: Node, region: Node, known: frozenset[bytes] = frozenset()) -> bool:
    """Tell whether a part of a region runs whenever the region does.

    Args:
        node: the part.
        region: a function, or a loop.
        known: what conditions may ask for, since it is another value at each time, or always the
            same one.
    """
    found = _conditions(node, region)
    return found is not None and all(asks_only_for(each, known) for each in found)


def _conditions(node: Node, region: Node) -> list[Node] | None:
    """Return what decides whether a part of a region runs; None where that is not known."""
    found: list[Node] = []
    current = node
    while current.id != region.id:
        parent = current.parent
        if parent is None:
            return None
        if parent.id != region.id and not (parent.type in _PLAIN or _decide(parent, found)):
            return None
        if parent.type in ("block", "module"):
            for before in parent.named_children:
                if before.start_byte >= current.start_byte:
                    break
                for exit_ in _exits(before):
                    around = _conditions_of_exit(exit_, before)
                    if around is None:
                        return None
                    found += around
        current = parent
    return found


def _decide(parent: Node, found: list[Node]) -> bool:
    """Add what a statement asks before it goes on; tell whether that is all there is."""
    if parent.type == "if_statement":
        found += parent.children_by_field_name("condition")
        for clause in parent.named_children:
            found += clause.children_by_field_name("condition")
        return True
    if parent.type == "for_statement":
        found += parent.children_by_field_name("right")
        return True
    return False


def _exits(statement: Node) -> Iterator[Node]:
    pending = [statement]
    while pending:
        node = pending.pop()
        if node.type in _EXITS:
            yield node
        elif node.type not in FUNCTIONS and node.type.endswith(
            ("statement", "clause", "block", "definition")
        ):
            pending += node.named_children


def _conditions_of_exit(node: Node, statement: Node) -> list[Node] | None:
    """Return the conditions under which a statement is left; None where that is not known."""
    found: list[Node] = []
    current = node
    while current.id != statement.id:
        parent = current.parent
        if parent is None or parent.type not in (
            "if_statement", "elif_clause", "else_clause", "block"
        ):  # fmt: skip
            return None
        if parent.type == "if_statement":
            _decide(parent, found)
        current = parent
    return found or None


def asks_only_for(expression: Node, known: frozenset[bytes]) -> bool:
    """Tell whether all that an expression asks for is of some names, or of Python itself."""
    pending = [expression]
    while pending:
        node = pending.pop()
        if node.type == "attribute" and (node.text or b"") in known:
            continue
        if node.type == "identifier" and not is_member(node):
            name = node.text or b""
            if name not in known and name.decode("utf-8", "replace") not in _BUILTINS:
                return False
        pending += node.named_children
    return True
