"""What a call says of a parameter: its type, default, range and description.

Sources: `ros/node_handle.h` of Noetic; `rclcpp/node.hpp`, `rclcpp/parameter.hpp`,
`rcl_interfaces/msg/ParameterDescriptor` of Jazzy.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.model.endpoint_details import ParameterDetails, Range

from .analysis import Analysis, Site
from .arguments import call_of
from .listed_parameters import value_of
from .read_parameters import AS_VALUE, ParameterCall, parameter_call
from .scopes import Scope, last_name, type_text
from .type_texts import template_arguments
from .value import Value

_SCALARS = {
    "bool": "bool",
    "float": "float",
    "double": "float",
    "std::string": "string",
    "string": "string",
    "constchar*": "string",
    "char": "string",
}
_INTEGERS = re.compile(
    r"(?:std::)?(?:u?int(?:8|16|32|64)?_t|size_t|(?:un)?signed(?:int|long|short)*|int|long(?:long)?"
    r"|(?:long|short)(?:int)?|uint|longint|longlongint|unsignedlonglong)"
)
_LIST = re.compile(r"(?:std::)?vector<(.+)>")
_NAMED = re.compile(
    r"(?:.*::)?PARAMETER_(?P<type>BOOL|INTEGER|DOUBLE|STRING|BYTE)(?P<list>_ARRAY)?"
)
_NAMES = {"BOOL": "bool", "INTEGER": "int", "DOUBLE": "float", "STRING": "string", "BYTE": "byte"}
_DESCRIPTOR = "rcl_interfaces::msg::ParameterDescriptor"
_RANGES = ("floating_point_range", "integer_range")
_ENDS = ("from_value", "to_value", "step")
_MOST_FIELDS = 64


def parameter_details(analysis: Analysis, site: Site) -> ParameterDetails:
    """Return what a call says of the parameter of a call site."""
    call, scope = site.call, site.place
    said = parameter_call(call)
    if call.name == "declare_parameters":
        said = ParameterCall(_listed(site))
    types = analysis.types
    named = _type_named(said.default, scope)
    default = said.default if named is None else None
    worth = analysis.callers.parameters.worth(default, scope, analysis.evaluator)
    set_to = analysis.evaluator.fold(said.value, scope)
    described = _described(analysis, said.descriptor, scope, call.node)
    type_ = (
        named
        or type_of_text(types.expand(_text(said.type, scope), scope))
        or type_of_worth(worth)
        or type_of_text(analysis.receivers.type_of(said.into, scope) if said.into else "")
        or type_of_worth(set_to)
        or described.type
        or _type_of_use(call.node, scope)
    )
    into = type_of_text(analysis.receivers.type_of(said.into, scope)) if said.into else None
    if analysis.ros_version == 1 and into is not None and said.type is None:
        type_ = into
    return ParameterDetails(
        type=type_,
        default=_fitted(worth, type_),
        default_expression=scope.file.syntax.slice(default) if default is not None else "",
        range=described.range,
        description=described.text,
        is_read_only=described.is_read_only,
        is_guess=worth is not None and (worth.is_default or worth.is_guess),
    )


def _listed(site: Site) -> Node | None:
    """Return what stands behind the name of a call site in the list of `declare_parameters`."""
    listed = site.arguments[1] if len(site.arguments) > 1 else None
    syntax = site.place.file.syntax
    if listed is not None and listed.type == "compound_literal_expression":
        listed = listed.child_by_field_name("value")
    for item in listed.named_children if listed is not None else ():
        first = item.named_children[0] if item.named_child_count else item
        if syntax.slice(first) == site.endpoint.expression:
            return value_of(site.arguments, first)
    return None


def _text(node: Node | None, scope: Scope) -> str:
    return type_text(scope.file.syntax.word(node)) if node is not None else ""


def type_of_text(text: str) -> str | None:
    """Return the type of parameter that a type of C++ is for, None for none."""
    if found := _LIST.fullmatch(text):
        inner = template_arguments(found[1])[0]
        if inner in ("uint8_t", "std::uint8_t", "unsignedchar", "std::byte"):
            return "byte_list"
        of = type_of_text(inner)
        return f"{of}_list" if of is not None and not of.endswith("_list") else None
    if text in _SCALARS:
        return _SCALARS[text]
    return "int" if text and _INTEGERS.fullmatch(text) else None


def type_of_worth(value: Value | None) -> str | None:
    """Return the type of parameter that a value is of, None for none."""
    if value is None:
        return None
    names = {bool: "bool", int: "int", float: "float", str: "string"}
    if isinstance(value.value, tuple):
        kinds = {type(each) for each in value.value}
        return f"{names[kinds.pop()]}_list" if len(kinds) == 1 else None
    return names[type(value.value)]


def _fitted(
    value: Value | None, type_: str | None
) -> bool | int | float | str | tuple[bool | int | float | str, ...] | None:
    """Return a default as it is in a variable of the type of the parameter."""
    if value is None:
        return None
    found = value.value
    if type_ == "float" and type(found) is int:
        return float(found)
    if type_ == "bool" and type(found) is int:
        return bool(found)
    if type_ == "int" and type(found) is float:
        return int(found) if abs(found) < 2**63 else None
    if type_ == "float_list" and isinstance(found, tuple):
        return tuple(float(each) if type(each) is int else each for each in found)
    if type_ is not None and type_.endswith("_list") and not isinstance(found, tuple):
        return None
    return found


def _type_named(node: Node | None, scope: Scope) -> str | None:
    """Return the type that `rclcpp::ParameterType::PARAMETER_DOUBLE` names."""
    if node is None or node.type not in ("qualified_identifier", "identifier"):
        return None
    found = _NAMED.fullmatch("".join(scope.file.syntax.word(node).split()))
    if found is None:
        return None
    return _NAMES[found["type"]] + ("_list" if found["list"] else "")


def _type_of_use(call: Node, scope: Scope) -> str | None:
    """Return the type that `get_parameter("x").as_double()` reads of a parameter."""
    field = call.parent
    if field is None or field.type != "field_expression" or field.parent is None:
        return None
    outer = call_of(field.parent, scope, scope.file.syntax)
    if outer is None:
        return None
    if outer.name in AS_VALUE:
        return AS_VALUE[outer.name]
    if outer.name in ("get", "get_value") and outer.type_nodes:
        return type_of_text(_text(outer.type_nodes[0], scope))
    return None


class _Described(NamedTuple):
    """What a `ParameterDescriptor` says."""

    type: str | None = None
    text: str | None = None
    range: Range | None = None
    is_read_only: bool = False


def _described(analysis: Analysis, node: Node | None, scope: Scope, at: Node) -> _Described:
    """Return what describes a parameter."""
    if node is None:
        return _Described()
    fields = dict(_fields(analysis, node, scope, at))
    found = _Described()
    for name, (value, place) in fields.items():
        match name:
            case "description":
                text = analysis.evaluator.fold(value, place)
                found = found._replace(text=text.text if text is not None else None)
            case "read_only":
                flag = analysis.evaluator.fold(value, place)
                found = found._replace(is_read_only=flag is not None and flag.value is True)
            case "type":
                found = found._replace(type=_type_named(value, place))
    kind = next((each for each in _RANGES if any(name.startswith(each) for name in fields)), None)
    if kind is not None:
        said = "float" if kind == "floating_point_range" else "int"
        found = found._replace(type=found.type or said, range=_range(analysis, fields, kind, at))
    return found


_Fields = Iterator[tuple[str, tuple[Node, Scope]]]


def _fields(analysis: Analysis, node: Node, scope: Scope, at: Node) -> _Fields:
    """Yield what the fields of a message are set to before a call, the last of each name last."""
    name = last_name(node, scope)
    syntax = scope.file.syntax
    if node.type == "call_expression":
        call = call_of(node, scope, syntax)
        if call is not None and call.name.startswith("set__") and call.receiver is not None:
            yield from _fields(analysis, call.receiver, scope, at)
            if call.arguments:
                yield call.name.removeprefix("set__"), (call.arguments[0], scope)
        return
    variable = analysis.unit.lookup(name, scope, node.start_byte) if name else None
    if variable is None:
        return
    if variable.value is not None and variable.value.type == "call_expression":
        yield from _fields(analysis, variable.value, variable.scope, at)
    for assignment, path, value, place in analysis.fields.of(name)[:_MOST_FIELDS]:
        is_before = place.file is scope.file and assignment.start_byte < at.start_byte
        if is_before and analysis.unit.lookup(name, place, assignment.start_byte) is variable:
            yield re.sub(r"\[0\]|\.at\(0\)|\.front\(\)", "", path), (value, place)
    for method in ("push_back", "emplace_back"):
        for call in analysis.unit.calls.get(method, ()):
            receiver = call.receiver
            if receiver is None or not call.arguments or call.node.start_byte > at.start_byte:
                continue
            text = "".join(call.scope.file.syntax.word(receiver).split())
            if call.scope.file is scope.file and text.startswith(f"{name}."):
                yield text.removeprefix(f"{name}."), (call.arguments[0], call.scope)


def _range(
    analysis: Analysis, fields: dict[str, tuple[Node, Scope]], kind: str, at: Node
) -> Range | None:
    """Return the range that a descriptor sets, None where it is not known."""
    ends = {end: fields[f"{kind}.{end}"] for end in _ENDS if f"{kind}.{end}" in fields}
    if not ends and kind in fields:
        node, scope = fields[kind]
        if node.type == "initializer_list" and node.named_child_count == 1:
            node = node.named_children[0]
        ends = {name: each for name, each in _fields(analysis, node, scope, at) if name in _ENDS}
        if not ends and node.type == "initializer_list":
            ends = {
                end: (each, scope) for end, each in zip(_ENDS, node.named_children, strict=False)
            }
    found = {}
    for end, (node, scope) in ends.items():
        value = analysis.evaluator.fold(node, scope)
        if value is None or value.number is None or value.is_default or value.is_guess:
            return None
        found[end] = value.number
    if "from_value" not in found or "to_value" not in found:
        return None
    return Range(found["from_value"], found["to_value"], found.get("step", 0))


__all__ = ["parameter_details", "type_of_text", "type_of_worth"]
