"""Parameters that a C++ node sets, or asks for in a list; ROS 2 refuses those not declared.

Source: `rclcpp/node.hpp` of Jazzy.
"""

from __future__ import annotations

from collections.abc import Iterator

from tree_sitter import Node

from plastron_tui.diagnostics import Span
from plastron_tui.model.code_facts import ParameterAccess, ParameterUse
from plastron_tui.sources.cpp.analysis import Analysis, NodeSite
from plastron_tui.sources.cpp.arguments import Call, arguments_of, call_of
from plastron_tui.sources.cpp.scopes import Scope

from .places import is_guarded

_METHODS = {
    "set_parameter": ParameterAccess.SET,
    "set_parameters": ParameterAccess.SET,
    "set_parameters_atomically": ParameterAccess.SET,
    "get_parameters": ParameterAccess.GET,
}


def set_uses(analysis: Analysis, maker: NodeSite) -> Iterator[ParameterUse]:
    """Yield what the methods of a node's class set of it, or ask for in a list."""
    if maker.owner is None:
        return
    bases = analysis.unit.bases(maker.owner)
    for method, access in _METHODS.items():
        own = method in analysis.unit.functions
        for call in () if own else analysis.unit.calls.get(method, ()):
            is_own = call.receiver is None or call.receiver.type == "this"
            if call.scope.file.is_beside or not is_own or not call.arguments:
                continue
            if any(analysis.unit.class_of(call.scope) is each for each in bases):
                yield from _named(analysis, call, access)


def _named(analysis: Analysis, call: Call, access: ParameterAccess) -> Iterator[ParameterUse]:
    given = call.arguments[0]
    items = [given] if call.name == "set_parameter" else _items(given)
    for item in items:
        node = item if access is ParameterAccess.GET else _first(item, call.scope)
        value = None if node is None else analysis.evaluator.fold(node, call.scope)
        if node is None or value is None or value.is_default or value.is_guess:
            continue
        if value.text is not None:
            span = Span(node.start_byte, node.end_byte)
            file = call.scope.file.name
            yield ParameterUse(access, value.text, span, file, is_guarded=is_guarded(call.node))


def _items(node: Node) -> list[Node]:
    """Return the elements of `{a, b}`, or of `std::vector<T>{a, b}`."""
    if node.type == "compound_literal_expression":
        return arguments_of(node.child_by_field_name("value"))
    return arguments_of(node) if node.type == "initializer_list" else []


def _first(node: Node, scope: Scope) -> Node | None:
    """Return the name in `rclcpp::Parameter("x", 1)`, or in `{"x", 1}`."""
    given = _items(node)
    if node.type == "call_expression":
        call = call_of(node, scope, scope.file.syntax)
        given = call.arguments if call is not None and call.name == "Parameter" else []
    return given[0] if len(given) == 2 else None
