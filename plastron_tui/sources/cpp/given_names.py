"""Names of topics and services that are the value of a parameter, or the full name of the node."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tree_sitter import Node

from plastron_tui.model.source import OWN_NAME
from plastron_tui.ros.names import spelled
from plastron_tui.sources.caller_limits import MOST_STEPS, are_followed

from .arguments import Call, call_of
from .read_parameters import AS_VALUE, parameter_call
from .receivers import NODELET, Prefix
from .scopes import Scope, Variable
from .unit import bound_calls

if TYPE_CHECKING:
    from .analysis import Analysis
    from .writes import Write

_SAME = frozenset({*AS_VALUE, "c_str", "str", "data", "get", "get_value", "get_parameter_value"})
_TEXTS = frozenset({"std::string", "string"})


def given_by(analysis: Analysis, node: Node | None, scope: Scope, depth: int = 0) -> str | None:
    """Return the parameter whose value an expression is as it stands: `~/topic` in ROS 1.

    `OWN_NAME` is the full name of the node. None where it is neither, or something is put to it.
    """
    if node is None or depth > MOST_STEPS:
        return None
    match node.type:
        case "identifier" | "field_identifier" | "type_identifier":
            name = scope.file.syntax.word(node)
            variable = analysis.unit.lookup(name, scope, node.start_byte)
            return None if variable is None else _held(analysis, variable, depth)
        case "field_expression":
            member = analysis.receivers.member(node, scope)
            return None if member is None else _held(analysis, member, depth)
        case "call_expression":
            call = call_of(node, scope, scope.file.syntax)
            return None if call is None else _called(analysis, call, depth)
        case "parameter_declaration":
            # `Server server(ros::this_node::getName());` may declare a function as well.
            type_node = node.child_by_field_name("type")
            called = "" if type_node is None else scope.file.syntax.word(type_node)
            return _own_name(analysis, called, scope)
        case _:
            return None


def _called(analysis: Analysis, call: Call, depth: int) -> str | None:
    given = call.arguments
    if call.receiver is not None and call.name in _SAME and not given:
        return given_by(analysis, call.receiver, call.scope, depth + 1)
    if call.qualified in _TEXTS and len(given) == 1:
        return given_by(analysis, given[0], call.scope, depth + 1)
    if not given and (own := _own_name(analysis, call.qualified, call.scope)) is not None:
        return own
    is_read = call.name in ("get_parameter", "declare_parameter", "param", "get_parameter_or")
    is_into = call.name != "declare_parameter" and parameter_call(call).into is not None
    return _parameter(analysis, call) if is_read and not is_into else None


def _own_name(analysis: Analysis, called: str, scope: Scope) -> str | None:
    if called.removeprefix("::") != "ros::this_node::getName":
        return None
    # That of a nodelet is its manager's.
    owner, nodelet = analysis.unit.class_of(scope), frozenset({NODELET})
    is_part = owner is not None and analysis.receivers.derives_from(owner, nodelet)
    return None if is_part else OWN_NAME


def _parameter(analysis: Analysis, call: Call) -> str | None:
    """Return the name of the parameter that a call reads; in ROS 1, of a private one alone."""
    value = analysis.evaluator.fold(call.argument(0), call.scope)
    if value is None or value.text is None or value.is_default or value.is_guess:
        return None
    if analysis.ros_version == 2:
        return value.text
    name = value.text
    if not name.startswith("~"):
        is_private = call.receiver is not None and not name.startswith("/")
        prefix = analysis.receivers.prefix(call.receiver, call.scope)
        if not is_private or prefix != Prefix("~"):
            return None
        name = f"~{name}"
    return spelled(name)


def _held(analysis: Analysis, variable: Variable, depth: int) -> str | None:
    """Return what gives a variable its value, wherever it can be asked for."""
    if variable.kind == "parameter":
        return _argument(analysis, variable, depth)
    if variable.kind == "loop" or analysis.unit.is_changed_unseen(variable):
        return None
    writes = analysis.unit.writes(variable)
    reads = [each.call for each in writes if each.call is not None]
    later = [each for each in writes if each.node.id != variable.node.id and each.call is None]
    if reads:
        # What it is made with is the default, what else is written to it may come behind.
        names = {_parameter(analysis, call) for call in reads}
        return names.pop() if len(names) == 1 and not later else None
    found = later or writes
    return _written(analysis, found[0], depth) if len(found) == 1 else None


def _written(analysis: Analysis, write: Write, depth: int) -> str | None:
    given = write.arguments or []
    value = write.value if write.value is not None or len(given) != 1 else given[0]
    return given_by(analysis, value, write.scope, depth + 1)


def _argument(analysis: Analysis, variable: Variable, depth: int) -> str | None:
    """Return what gives a parameter of a function its value, by all calls alike."""
    function, callers = variable.scope.function, analysis.callers
    if function is None or variable not in function.parameters:
        return None
    position = function.parameters.index(variable)
    bound = analysis.unit.bindings.get(function)
    calls = callers.of(function) if bound is None else bound_calls(bound)
    if not are_followed(len(calls), depth):
        return None
    found = {
        given_by(analysis, callers.given(call, function, position), call.scope, depth + 1)
        for call in calls
    }
    return found.pop() if len(found) == 1 else None
