"""From rclpy to rospy: `rclpy.shutdown()`, which has nothing to do once `rospy.spin` returns."""

from __future__ import annotations

from collections.abc import Iterator

from tree_sitter import Node

from plastron_tui.sources.python.references import statement_of
from plastron_tui.sources.python.syntax import parts_of

from .contexts import leave_try
from .port_state import Work, walk

_LEAVES = frozenset({"break_statement", "return_statement"})
_HOLDS = frozenset({"block", "try_statement", "with_statement"})


def port_shutdown(work: Work, call: Node, *, is_alone: bool) -> None:
    """Leave out a shutdown behind `spin`, which returns when the node is shut down already."""
    statement = _with_question(work, statement_of(call))
    if is_alone and _is_behind_spin(work, statement):
        work.delete(statement)
    else:
        work.replace(call, f"rospy.signal_shutdown({work.string('the node is done')})")


def leave_empty_clauses(work: Work) -> None:
    """Take away each `finally` that nothing is left in, and a `try` that was for it alone."""
    for clause in walk(work.analysis.syntax.root):
        if clause.type != "finally_clause" or clause.parent is None:
            continue
        statements = [each for block in clause.named_children for each in parts_of(block)]
        if not statements or not all(map(work.is_gone, statements)):
            continue
        work.delete(clause)
        if clause.parent.named_child_count == 2:  # the body, and what ends it
            leave_try(work, clause.parent)


def _with_question(work: Work, statement: Node) -> Node:
    """Return the `if rclpy.ok():` that holds nothing but a statement, or the statement."""
    block = statement.parent
    check = block.parent if block is not None and parts_of(block) == [statement] else None
    if check is None or check.type != "if_statement" or check.child_by_field_name("alternative"):
        return statement
    return check if _asks_ok(work, check) else statement


def _asks_ok(work: Work, statement: Node) -> bool:
    condition = statement.child_by_field_name("condition")
    callee = condition.child_by_field_name("function") if condition is not None else None
    return callee is not None and "rclpy.ok" in work.qualified(callee)


def _is_behind_spin(work: Work, statement: Node) -> bool:
    """Tell whether a statement runs behind `spin`, or behind what failed before it.

    The end of the program shuts the node down as well, if no thread keeps the program alive.
    """
    has_threads = b"Thread(" in work.analysis.syntax.text
    current: Node | None = statement
    while current is not None and not current.type.endswith("_definition"):
        if any(_spins(work, each, has_threads) for each in _before(current)):
            return True
        current = current.parent
    return False


def _before(node: Node) -> Iterator[Node]:
    sibling = node.prev_named_sibling
    while sibling is not None:
        yield sibling
        sibling = sibling.prev_named_sibling


def _spins(work: Work, node: Node, has_threads: bool) -> bool:
    """Tell whether a statement returns when the node is shut down, and not before."""
    if node.type == "while_statement":
        return _asks_ok(work, node) and not any(each.type in _LEAVES for each in walk(node))
    if node.type in _HOLDS and not (has_threads and node.type == "try_statement"):
        body = [node] if node.type == "block" else [node.child_by_field_name("body")]
        return any(_spins(work, each, has_threads) for block in body for each in parts_of(block))
    call = node.named_children[0] if node.type == "expression_statement" else None
    callee = call.child_by_field_name("function") if call is not None else None
    if callee is None:
        return False
    part = callee.child_by_field_name("attribute")
    return "rclpy.spin" in work.qualified(callee) or (
        part is not None and work.slice(part) == "spin"
    )
