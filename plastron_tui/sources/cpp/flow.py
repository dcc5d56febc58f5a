"""Which of several values a local variable has at a place of its function."""

from __future__ import annotations

from collections.abc import Sequence

from tree_sitter import Node

from .scopes import Scope
from .writes import Write

_LOOPS = frozenset({"for_statement", "for_range_loop", "while_statement", "do_statement"})


def reaching_write(writes: Sequence[Write], at: Node, scope: Scope) -> list[Write] | None:
    """Return what was written before a place, the last of it last, where that is sure.

    It is sure where the statements come one after the other: the last one stands in a block around
    the place, and no loop around the place writes again behind it. Otherwise the result is None.
    """
    function = scope.enclosing("function", "lambda")
    before = [write for write in writes if write.node.start_byte < at.start_byte]
    before = [write for write in before if write.node.end_byte <= at.start_byte]
    if not before or any(
        each.scope.enclosing("function", "lambda") is not function for each in writes
    ):
        return None
    before.sort(key=lambda write: write.node.start_byte)
    chain = [id(each) for each in scope.chain]
    last = before[-1]
    if id(last.scope) not in chain:
        return None
    for each in scope.chain:
        if each is function:
            break
        # A loop that writes later has the value of the turn before, unless this turn writes first.
        is_loop = each.node.type in _LOOPS and last.node.start_byte < each.start
        if is_loop and any(at.start_byte <= write.node.start_byte < each.end for write in writes):
            return None
    # What a branch writes on the way is seen by who comes behind it only where it is the last.
    sure = [write for write in before if id(write.scope) in chain]
    return sure if sure[-1] is last else None
