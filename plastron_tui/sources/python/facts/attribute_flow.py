"""Which of the values of an attribute is the one that a line sees, where its function gives one."""

from __future__ import annotations

from collections.abc import Sequence

from tree_sitter import Node

from plastron_tui.sources.grammars import is_inside
from plastron_tui.sources.python.references import statement_of
from plastron_tui.sources.python.scopes import Binding, Scope
from plastron_tui.sources.python.syntax import FUNCTIONS, REPEATING


def last_in_function(bindings: list[Binding], node: Node, scope: Scope) -> list[Binding]:
    """Return the assignment that a use of an attribute comes behind, or all where that is not sure.

    Args:
        bindings: what gives the attribute a value anywhere.
        node: the use.
        scope: the scope of the use.
    """
    own = [each for each in bindings if each.scope is scope and each.node.type == "assignment"]
    before = [each for each in own if each.node.end_byte <= node.start_byte]
    if len(bindings) < 2 or not before:
        return bindings
    last = max(before, key=lambda each: each.node.end_byte)
    block = statement_of(last.node).parent
    if block is None or not is_inside(node, block) or _comes_round(last, own, node):
        return bindings
    return [last]


def _comes_round(last: Binding, own: Sequence[Binding], node: Node) -> bool:
    """Whether a loop may bring the value of another assignment to the use."""
    current = node.parent
    while current is not None and current.type not in FUNCTIONS:
        is_around = current.type in REPEATING and not is_inside(last.node, current)
        if is_around and any(is_inside(each.node, current) for each in own):
            return True
        current = current.parent
    return False
