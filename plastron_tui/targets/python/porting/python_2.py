"""From rospy to rclpy: what Python 2 had, and Python 3, which ROS 2 is of, calls otherwise."""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.sources.python.syntax import parts_of

from .port_state import Work

_FUNCTIONS = {"raw_input": "input", "xrange": "range", "unicode": "str"}
_METHODS = {"iteritems": "items", "itervalues": "values", "iterkeys": "keys"}


def port_python_2(work: Work) -> None:
    """Rewrite the functions and methods of Python 2, where the file has none of the name."""
    for call in work.analysis.captures.get("call", []):
        callee = call.child_by_field_name("function")
        if callee is None or work.is_gone(call):
            continue
        if callee.type == "identifier":
            _port_function(work, callee)
        elif callee.type == "attribute":
            _port_method(work, call, callee)


def _port_function(work: Work, callee: Node) -> None:
    name = work.slice(callee)
    new = _FUNCTIONS.get(name)
    scope = work.scope(callee)
    if new is not None and scope.lookup(name) is None and scope.lookup(new) is None:
        work.replace(callee, new)


def _port_method(work: Work, call: Node, callee: Node) -> None:
    part = callee.child_by_field_name("attribute")
    given = parts_of(call.child_by_field_name("arguments"))
    name = work.slice(part) if part is not None else ""
    if part is None or work.analysis.resolver.attribute_bindings(callee, work.scope(callee)):
        return
    if name in _METHODS and not given:
        work.replace(part, _METHODS[name])
    elif name == "has_key" and len(given) == 1:
        _port_has_key(work, call, callee, given[0])


def _port_has_key(work: Work, call: Node, callee: Node, key: Node) -> None:
    """Write `held.has_key(key)` as `key in held`, which binds less closely than a call."""
    holder, parent = callee.child_by_field_name("object"), call.parent
    if holder is None or parent is None or key.type not in _SIMPLE:
        work.mark(call, ".has_key", "`key in ...`, in Python 3")
        return
    if parent.type == "not_operator":
        work.replace(parent, f"{work.text(key)} not in {work.text(holder)}")
        return
    written = f"{work.text(key)} in {work.text(holder)}"
    work.replace(call, written if parent.type in _LOOSE else f"({written})")


_SIMPLE = frozenset({"identifier", "attribute", "string", "integer", "call", "subscript"})
_LOOSE = frozenset(
    {
        "if_statement",
        "elif_clause",
        "while_statement",
        "assignment",
        "argument_list",
        "boolean_operator",
        "return_statement",
        "parenthesized_expression",
        "expression_statement",
        "assert_statement",
    }
)
"""What binds less closely than `in`."""
