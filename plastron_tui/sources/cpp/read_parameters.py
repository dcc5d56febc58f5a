"""What reading a parameter of ROS gives: its default, where nobody sets it otherwise.

Source: `ros/node_handle.h`, `ros/param.h` of Noetic; `rclcpp/node.hpp` of Jazzy.
"""

from __future__ import annotations

import re
from functools import cached_property
from typing import NamedTuple

from tree_sitter import Node

from .arguments import Call, call_of
from .scopes import Scope
from .unit import Unit
from .value import Value
from .values import Evaluator

AS_VALUE = {
    "as_string": "string",
    "as_int": "int",
    "as_double": "float",
    "as_bool": "bool",
    "as_byte_array": "byte_list",
    "as_bool_array": "bool_list",
    "as_integer_array": "int_list",
    "as_double_array": "float_list",
    "as_string_array": "string_list",
}
"""The methods of `rclcpp::Parameter` that give its value, and the type that each is of."""

_UNLESS_SET = re.compile(r"\(!(?:\w|\.|->|\(\))*hasParam\(.*\)\)")
_FEW = 3
"""How far above a call the condition may be under which it is made: block, statement."""

_VALUES = frozenset({*AS_VALUE, "get", "get_value", "get_parameter_value"})


class ParameterCall(NamedTuple):
    """What one call gives for a parameter.

    Attributes:
        default: what the parameter has where nobody sets it.
        into: the variable that gets its value.
        value: what the call sets it to.
        type: the template argument that says its type.
        descriptor: what describes it.
    """

    default: Node | None = None
    into: Node | None = None
    value: Node | None = None
    type: Node | None = None
    descriptor: Node | None = None


def parameter_call(call: Call) -> ParameterCall:
    """Return what a call that reads, declares or sets a parameter gives for it."""
    given = call.arguments
    types = call.type_nodes
    type_ = types[0] if types else None
    match call.name:
        case "param" | "get_parameter_or":
            if len(given) >= 3:
                return ParameterCall(given[2], given[1], type=type_)
            return ParameterCall(call.argument(1), type=type_)
        case "getParam" | "getParamCached" | "get" | "getCached" | "get_parameter":
            return ParameterCall(into=call.argument(1), type=type_)
        case "setParam" if _is_unless_set(call):
            return ParameterCall(call.argument(1))
        case "setParam" | "set" | "set_parameter":
            return ParameterCall(value=call.argument(1))
        case "declare_parameter":
            return ParameterCall(call.argument(1), type=type_, descriptor=call.argument(2))
        case _:
            return ParameterCall()


def _is_unless_set(call: Call) -> bool:
    """Tell whether a parameter is set where nobody has set it: `if (!nh.hasParam(name))`."""
    syntax = call.scope.file.syntax
    name = call.argument(0)
    above = call.node.parent
    for _ in range(_FEW):
        if above is None or name is None:
            return False
        if above.type == "if_statement":
            condition = above.child_by_field_name("condition")
            text = "" if condition is None else "".join(syntax.slice(condition).split())
            own = "".join(syntax.slice(name).split())
            return bool(_UNLESS_SET.fullmatch(text)) and text.endswith(f"hasParam({own}))")
        above = above.parent
    return False


class ReadParameters:
    """The parameters that the files of a unit read."""

    def __init__(self, unit: Unit) -> None:
        self._unit = unit
        self._busy = False

    @cached_property
    def declared(self) -> dict[str, list[tuple[Node, Scope]]]:
        """The defaults that are declared, by the parameter's name."""
        return {}

    def declare(self, evaluator: Evaluator) -> None:
        """Look for the declarations, whose names may be constants."""
        for call in self._unit.calls.get("declare_parameter", ())[:2_000]:
            name = evaluator.fold(call.argument(0), call.scope)
            default = call.argument(1)
            if name is not None and name.text is not None and default is not None:
                self.declared.setdefault(name.text, []).append((default, call.scope))

    def read_by(self, call: Call, evaluator: Evaluator) -> Value | None:
        """Return what a call gives that reads a parameter."""
        if call.name in _VALUES and call.receiver is not None and not call.arguments:
            receiver = call.receiver
            if receiver.type == "call_expression":
                inner = call_of(receiver, call.scope, call.scope.file.syntax)
                return self.read_by(inner, evaluator) if inner is not None else None
            value = evaluator.fold(receiver, call.scope)
            return value if value is not None and value.is_default else None
        said = parameter_call(call)
        if call.name in ("declare_parameter", "param", "get_parameter_or"):
            if said.into is not None and call.name != "declare_parameter":
                return None
            return _as_default(self.worth(said.default, call.scope, evaluator))
        if call.name == "get_parameter" and len(call.arguments) == 1:
            return self._declared_value(call, evaluator)
        return None

    def read_into(self, call: Call, evaluator: Evaluator, before: Value | None) -> Value | None:
        """Return what a variable has after a call that reads a parameter into it."""
        said = parameter_call(call)
        if said.default is not None:
            return _as_default(self.worth(said.default, call.scope, evaluator))
        if call.name == "get_parameter":
            return self._declared_value(call, evaluator) or _as_default(before)
        return _as_default(before)

    def _declared_value(self, call: Call, evaluator: Evaluator) -> Value | None:
        name = evaluator.fold(call.argument(0), call.scope)
        if name is None or name.text is None:
            return None
        found = {
            self.worth(default, scope, evaluator)
            for default, scope in self.declared.get(name.text, ())[:8]
        }
        return _as_default(found.pop()) if len(found) == 1 else None

    def worth(self, node: Node | None, scope: Scope, evaluator: Evaluator) -> Value | None:
        """Return the value of a default, also of one in a `ParameterValue`."""
        if node is not None and node.type == "call_expression":
            call = call_of(node, scope, scope.file.syntax)
            if call is not None and call.name == "ParameterValue" and len(call.arguments) == 1:
                node = call.arguments[0]
        return evaluator.before(node, scope) if node is not None else None


def _as_default(value: Value | None) -> Value | None:
    return None if value is None else value._replace(is_default=True)
