"""Programs that make a node of a class of another file, and leave it at that."""

from __future__ import annotations

from collections.abc import Callable

from tree_sitter import Node

from plastron_tui.sources.python.analysis import Analysis
from plastron_tui.sources.python.references import Use, references, variable_of

from .base_files import Base
from .called_back import running_scope

_HARMLESS = frozenset(
    {
        "destroy_node", "get_clock", "get_logger", "get_name", "trigger_activate",
        "trigger_cleanup", "trigger_configure", "trigger_deactivate", "trigger_shutdown",
    }
)  # fmt: skip
"""What a node does that has no callback of its endpoints called."""

_ADDING = "add_node"
_CONDITIONS = frozenset({"elif_clause", "if_statement", "while_statement"})
_TESTS = frozenset({"boolean_operator", "not_operator", "parenthesized_expression"})


def imported_idle(analysis: Analysis, is_idle: Callable[[Base], bool]) -> Node | None:
    """Return what makes a node of a class of another file that nothing is done with.

    Args:
        analysis: a program that calls nothing that spins.
        is_idle: tells whether a class is that of a node which has callbacks and never spins itself.
    """
    package = analysis.package
    calls = analysis.captures.get("call", []) if package is not None else []
    for call in calls:
        scope = running_scope(analysis, call)
        callee = call.child_by_field_name("function")
        if package is None or scope.enclosing("class") is not None or not _is_left(call, analysis):
            continue
        names = analysis.resolver.qualified(callee, scope)
        held = package.class_(names[0]) if len(names) == 1 else None
        if held is not None and is_idle(Base(package.complete(held[0]), held[1])):
            return call
    return None


def _is_left(made: Node, analysis: Analysis) -> bool:
    """Tell whether nothing is done with an object that could have its callbacks called."""
    parent = made.parent
    if parent is not None and parent.type == "expression_statement":
        return True
    target = parent.child_by_field_name("left") if parent is not None else None
    if parent is None or parent.type != "assignment" or target is None:
        return False
    variable = variable_of(target, analysis) if target.type == "identifier" else None
    # What a module has, other files may import.
    if variable is None or analysis.scopes.at(target.start_byte).kind == "module":
        return False
    return all(
        each.use in (Use.BINDING, Use.NOTHING) or is_harmless(each.node, analysis)
        for each in references(variable, analysis)
    )


def is_harmless(node: Node, analysis: Analysis, *, is_added: bool = True) -> bool:
    """Tell whether a use of a node has no callback called.

    Args:
        node: the name of the node, where it is used.
        analysis: the file.
        is_added: whether an executor may get the node as well, in a file where none spins.
    """
    parent = node.parent
    if _is_asked_for(node):
        return True
    call = parent.parent if parent is not None else None
    if parent is None or call is None or call.type != "call":
        return False
    name = analysis.syntax.called_name(call)
    if parent.type == "argument_list":
        return name in (_ADDING, "destroy_node") and is_added
    return parent.type == "attribute" and name in _HARMLESS


def _is_asked_for(node: Node) -> bool:
    """Tell whether it is only asked whether there is a node: `if node:`, `node is not None`."""
    test = node
    while test.parent is not None and test.parent.type in _TESTS:
        test = test.parent
    parent = test.parent
    if parent is None:
        return False
    if parent.type == "comparison_operator":
        return any(each.type == "none" for each in parent.named_children)
    condition = parent.child_by_field_name("condition") if parent.type in _CONDITIONS else None
    return condition is not None and condition.id == test.id
