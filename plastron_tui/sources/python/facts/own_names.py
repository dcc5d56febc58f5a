"""Names that a file gives itself, so that what they stand for is said in the file."""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.sources.python.analysis import Analysis
from plastron_tui.sources.python.imports import is_interface_module
from plastron_tui.sources.python.scopes import BindingKind

_OWN = frozenset({BindingKind.FUNCTION, BindingKind.VALUE})


def is_own_name(node: Node, analysis: Analysis) -> bool:
    """Tell whether a name is that of a value or method of the file, or of an interface type.

    Of a parameter others say what it is, and of an attribute of anything but `self`.
    """
    parent = node.parent
    if parent is None:
        return False
    if parent.type == "function_definition":
        return True
    scope = analysis.scopes.at(node.start_byte)
    name = analysis.syntax.slice(node)
    if parent.type == "attribute" and parent.child_by_field_name("attribute") == node:
        holder = parent.child_by_field_name("object")
        method = scope.enclosing("function")
        owner = scope.enclosing("class")
        if holder is None or method is None or owner is None or not method.self_name:
            return False
        is_self = analysis.syntax.slice(holder) == method.self_name
        bindings = [*owner.attributes.get(name, ()), *owner.bindings.get(name, ())]
    else:
        names = analysis.resolver.qualified(node, scope)
        if names and all(is_interface_module(each) for each in names):
            return True
        found = scope.lookup(name)
        is_self, bindings = True, [] if found is None else found[1]
    return (
        is_self
        and bool(bindings)
        and all(
            each.kind in _OWN and (each.kind is BindingKind.FUNCTION or each.value is not None)
            for each in bindings
        )
    )
