"""Programs that make a node of a class of another file, and leave it at that."""

from __future__ import annotations

from collections.abc import Callable

from tree_sitter import Node

from plastron_tui.sources.python.analysis import Analysis
from plastron_tui.sources.python.references import Use, references, variable_of

from .base_files import Base
from .called_back import running_scope

_HARMLESS = frozenset({"add_node", "destroy_node", "get_clock", "get_logger", "get_name"})
"""What is done with a node, by it or with it, that has no callback called."""

_PARENTS = frozenset({"argument_list", "attribute"})


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
        each.use is Use.BINDING or _is_harmless(each.node, analysis)
        for each in references(variable, analysis)
    )


def _is_harmless(node: Node, analysis: Analysis) -> bool:
    parent = node.parent
    call = parent.parent if parent is not None and parent.type in _PARENTS else None
    is_call = call is not None and call.type == "call"
    return is_call and call is not None and analysis.syntax.called_name(call) in _HARMLESS
