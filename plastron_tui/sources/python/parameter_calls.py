"""The calls that declare, read and set parameters: which argument says what.

Source: `rospy.client` of Noetic, `rclpy.node.Node` and `rclpy.parameter.Parameter` of Jazzy.
"""

from __future__ import annotations

from typing import NamedTuple

from tree_sitter import Node

from .analysis import Analysis, Site
from .arguments import Arguments
from .calls import Argument
from .syntax import parts_of

READERS = {
    f"{module}.{name}": Argument(1, "default")
    for module in ("rospy", "rospy.client")
    for name in ("get_param", "get_param_cached")
}
"""The functions that read a parameter, and the argument that is its default."""

_SETTERS = frozenset({"rospy.set_param", "rospy.client.set_param"})
_PARAMETER = frozenset({"rclpy.Parameter", "rclpy.parameter.Parameter", "rclpy.node.Parameter"})
# Each of a list is looked for in it.
_MOST_LISTED = 200
_DECLARED = Argument(1, "value")
_DESCRIPTOR = Argument(2, "descriptor")

VALUE_FIELDS = {
    "bool_value": "bool",
    "integer_value": "int",
    "double_value": "float",
    "string_value": "string",
    "byte_array_value": "byte_list",
    "bool_array_value": "bool_list",
    "integer_array_value": "int_list",
    "double_array_value": "float_list",
    "string_array_value": "string_list",
}
"""The fields of `rcl_interfaces/msg/ParameterValue`, and the type of parameter that each is of."""


class ParameterCall(NamedTuple):
    """What one call gives for a parameter.

    Attributes:
        default: what the parameter has where nobody sets it, or a type alone that it has.
        value: what the call sets it to.
        type: what alone says its type.
        descriptor: what describes it.
    """

    default: Node | None = None
    value: Node | None = None
    type: Node | None = None
    descriptor: Node | None = None


def parameter_call(analysis: Analysis, site: Site) -> ParameterCall:
    """Return what a call gives for the parameter of a call site."""
    arguments, callees = site.arguments, site.shape.callees
    if callees[0] in READERS:
        return ParameterCall(default=arguments.get(READERS[callees[0]]))
    if callees[0] in _SETTERS:
        return ParameterCall(value=arguments.get(Argument(1, "param_value")))
    if "declare_parameter" in callees:
        default, descriptor = arguments.get(_DECLARED), arguments.get(_DESCRIPTOR)
        return ParameterCall(default, descriptor=descriptor)
    if "declare_parameters" in callees:
        given = [*_listed(analysis, site), None, None]
        return ParameterCall(given[0], descriptor=given[1])
    if "get_parameter_or" in callees:
        return _alternative(analysis, site)
    return ParameterCall()


def _listed(analysis: Analysis, site: Site) -> list[Node]:
    """Return what stands behind the name of a call site in the list of `declare_parameters`."""
    item = item_of(analysis, site)
    return [] if item is None else parts_of(item)[1:]


def item_of(analysis: Analysis, site: Site) -> Node | None:
    """Return the part of the list of `declare_parameters` that is a parameter, None for none."""
    if "declare_parameters" not in site.shape.callees:
        return None
    listed = site.arguments.get(site.shape.name)
    if listed is None or listed.named_child_count > _MOST_LISTED:
        return None
    for item in parts_of(listed):
        parts = parts_of(item) if item.type == "tuple" else []
        if parts and analysis.syntax.slice(parts[0]) == site.endpoint.expression:
            return item
    return None


def _alternative(analysis: Analysis, site: Site) -> ParameterCall:
    """Return what `get_parameter_or('x', Parameter('x', Parameter.Type.DOUBLE, 1.0))` gives."""
    given = site.arguments.get(Argument(1, "alternative_value"))
    held = analysis.resolver.containers.literal(given, site.scope)
    if held is None or held.node.type != "call" or held.scope is not site.scope:
        return ParameterCall()
    callee = held.node.child_by_field_name("function")
    if _PARAMETER.isdisjoint(analysis.resolver.qualified(callee, held.scope)):
        return ParameterCall()
    arguments = Arguments.of(held.node, analysis.syntax)
    type_, value = arguments.get(Argument(1, "type_")), arguments.get(Argument(2, "value"))
    return ParameterCall(value, type=type_)
