"""Variables of a ported file that hold a node only to have it spun, which rospy does without."""

from __future__ import annotations

from collections import Counter

from tree_sitter import Node

from plastron_tui.sources.python.splices import Splice, apply
from plastron_tui.sources.python.syntax import Syntax, parse

from .port_state import walk


def without_unused_nodes(text: bytes, classes: frozenset[str]) -> bytes:
    """Make nodes without a variable where a function does nothing else with it.

    Those of a module stay: other files may ask for them.

    Args:
        text: the ported file.
        classes: what makes a node: the classes of the file, or `rospy.init_node`.
    """
    syntax = parse(text)
    splices: list[Splice] = []
    for function in walk(syntax.root):
        if function.type != "function_definition":
            continue
        names = Counter(syntax.slice(node) for node in walk(function) if node.type == "identifier")
        for assignment in walk(function):
            if assignment.type == "assignment" and _makes(syntax, assignment, classes):
                name, value = (assignment.child_by_field_name(each) for each in ("left", "right"))
                if name is not None and value is not None and names[syntax.slice(name)] == 1:
                    splices.append(Splice(name.start_byte, value.start_byte))
    return apply(text, splices)


def _makes(syntax: Syntax, assignment: Node, classes: frozenset[str]) -> bool:
    """Whether an assignment binds a plain name to a new node."""
    name, value = (assignment.child_by_field_name(each) for each in ("left", "right"))
    callee = value.child_by_field_name("function") if value is not None else None
    is_plain = name is not None and name.type == "identifier"
    return is_plain and callee is not None and syntax.slice(callee) in classes
