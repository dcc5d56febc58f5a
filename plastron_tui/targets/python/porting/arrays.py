"""From rospy to rclpy: arrays of numbers in messages, which are no lists there.

Source: the setters of `rosidl_generator_py`: an array of a fixed length is one of numpy, any
other one of integers or floats an `array.array`.
"""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.ros.interfaces import FieldType
from plastron_tui.sources.python.splices import Splice

from .message_types import typed
from .port_state import Work, walk

_OF_LISTS = frozenset(
    {"append", "extend", "insert", "pop", "remove", "clear", "reverse", "index", "count"}
)
_NOT_OF_ARRAYS = frozenset({"clear", "copy", "sort"})


def port_arrays(work: Work) -> None:
    """Write what moves an array of numbers on as rclpy takes it, and mark what it has not."""
    for node in walk(work.analysis.syntax.root):
        if node.type == "augmented_assignment":
            _port_augmented(work, node)
        elif node.type == "call":
            _mark_method(work, node)


def _port_augmented(work: Work, node: Node) -> None:
    """Rewrite `x.data += [1]`: an `array.array` adds nothing but its like."""
    left, right = node.child_by_field_name("left"), node.child_by_field_name("right")
    operator = node.child_by_field_name("operator")
    type_ = _numbers(work, left)
    if left is None or right is None or operator is None or type_ is None:
        return
    if type_.length is not None:
        _mark_numpy(work, node, left)
    elif work.slice(operator) != "+=" or not _is_whole(right):
        work.mark(node, work.slice(left), "it is an `array.array`, which adds nothing but its like")
    else:
        encode = work.analysis.syntax.encode
        work.cut(Splice(left.end_byte, right.start_byte, encode(".extend(")))
        work.insert_last(right.end_byte, ")")


def _is_whole(value: Node) -> bool:
    """Tell whether an expression is one argument as it stands."""
    return value.type not in ("expression_list", "yield", "assignment", "augmented_assignment")


def _mark_method(work: Work, call: Node) -> None:
    callee = call.child_by_field_name("function")
    holder = callee.child_by_field_name("object") if callee is not None else None
    part = callee.child_by_field_name("attribute") if callee is not None else None
    type_ = _numbers(work, holder)
    if holder is None or part is None or type_ is None:
        return
    method = work.slice(part)
    if type_.length is not None and method in _OF_LISTS:
        _mark_numpy(work, call, holder)
    elif type_.length is None and method in _NOT_OF_ARRAYS:
        work.mark(call, f"{work.slice(holder)}.{method}", "it is an `array.array`, and no list")


def _numbers(work: Work, node: Node | None) -> FieldType | None:
    """Return the type of a field of a message that is an array of numbers."""
    type_ = typed(work, node) if node is not None and node.type == "attribute" else None
    if not isinstance(type_, FieldType) or not type_.is_array or type_.package is not None:
        return None
    return type_ if type_.name.startswith(("float", "int", "uint")) else None


def _mark_numpy(work: Work, node: Node, holder: Node) -> None:
    work.mark(node, work.slice(holder), "it is an array of numpy, which keeps its length")
