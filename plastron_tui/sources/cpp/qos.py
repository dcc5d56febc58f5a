"""The quality of service that a call gives an endpoint, as far as the files say it for sure.

Sources: `ros/node_handle.h` of Noetic; `rclcpp/qos.hpp`, `rmw/qos_profiles.h`, `tf2_ros/qos.hpp`
of Jazzy.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind
from plastron_tui.ros.qos import BEST_AVAILABLE, DEFAULT, PROFILES, SYSTEM_DEFAULT, Qos

from .durations import seconds
from .held import Held
from .scopes import Scope, Variable, last_name

if TYPE_CHECKING:
    from .analysis import Analysis
    from .found import Found

_MOST_DEEP = 24
_MOST_CHANGES = 32

_CLASSES = {
    "rclcpp::SensorDataQoS": PROFILES["sensor_data"],
    "rclcpp::SystemDefaultsQoS": PROFILES["system_default"],
    "rclcpp::ServicesQoS": PROFILES["services_default"],
    "rclcpp::ParametersQoS": PROFILES["parameters"],
    "rclcpp::ParameterEventsQoS": PROFILES["parameter_events"],
    "rclcpp::RosoutQoS": PROFILES["rosout_default"],
    "rclcpp::BestAvailableQoS": PROFILES["best_available"],
    "rclcpp::ClockQoS": DEFAULT._replace(depth=1, reliability="best_effort"),
    "tf2_ros::DynamicListenerQoS": DEFAULT._replace(depth=100),
    "tf2_ros::DynamicBroadcasterQoS": DEFAULT._replace(depth=100),
    "tf2_ros::StaticListenerQoS": DEFAULT._replace(depth=100, durability="transient_local"),
    "tf2_ros::StaticBroadcasterQoS": DEFAULT._replace(depth=1, durability="transient_local"),
}
_WORDS = {
    "reliable": ("reliability", "reliable"),
    "best_effort": ("reliability", "best_effort"),
    "reliability_best_available": ("reliability", BEST_AVAILABLE),
    "transient_local": ("durability", "transient_local"),
    "durability_volatile": ("durability", "volatile"),
    "durability_best_available": ("durability", BEST_AVAILABLE),
}
_POLICIES = {
    "reliability": "reliability",
    "durability": "durability",
    "history": "history",
    "liveliness": "liveliness",
    "deadline": "deadline",
    "lifespan": "lifespan",
    "liveliness_lease_duration": "lease",
    "depth": "depth",
}
_VALUES = {
    "reliable": "reliable",
    "besteffort": "best_effort",
    "volatile": "volatile",
    "transientlocal": "transient_local",
    "keeplast": "keep_last",
    "keepall": "keep_all",
    "automatic": "automatic",
    "manualbytopic": "manual_by_topic",
    "systemdefault": SYSTEM_DEFAULT,
    "bestavailable": BEST_AVAILABLE,
}
_RMW = re.compile(r"(?:rmw_qos_profile|rclcpp::rmw_qos_profile)_(\w+)")
_POLICY = re.compile(r"(?:RMW_QOS_POLICY_(?:RELIABILITY|DURABILITY|HISTORY|LIVELINESS)_)?(\w+)")


def qos_of(analysis: Analysis, found: Found) -> Qos | None:
    """Return the quality of service that a call gives what it creates; None for none known."""
    shape = found.shape
    if shape.kind not in (EndpointKind.PUBLISHER, EndpointKind.SUBSCRIPTION):
        return None
    scope = (found.options or found.call).scope
    given = found.arguments
    node = given[shape.queue] if shape.queue is not None and shape.queue < len(given) else None
    qos: Qos | None
    if analysis.ros_version == 1:
        qos = _of_ros1(analysis, found, node, scope)
    elif node is None:
        has_default = shape.queue is not None and shape.on in ("function", "filter")
        qos = DEFAULT if has_default and shape.type != "template" else None
        if qos is None and "message_filters" in _made_name(found):
            qos = DEFAULT
    elif _may_be_overridden(found):
        return None
    else:
        qos = profile(analysis, node, scope)
    if qos is None:
        return None
    if qos.history == "keep_all" and qos.depth is not None:
        qos = qos._replace(depth=None)
    return qos if any(policy is not None for policy in qos) else None


def _made_name(found: Found) -> str:
    return "message_filters" if found.template else ""


def _may_be_overridden(found: Found) -> bool:
    """Whether parameters may change it when the node starts."""
    syntax = found.call.scope.file.syntax
    if not syntax.overrides_qos:
        return False
    code = syntax.code
    last = found.arguments[-1]
    text = found.call.scope.file.syntax.word(last)
    name = last_name(last, found.call.scope) or text.partition("(")[0]
    return f"{name}.qos_overriding_options".encode() in code or "QosOverriding" in text


def _of_ros1(analysis: Analysis, found: Found, node: Node | None, scope: Scope) -> Qos:
    """Return what ROS 1 has of it: it is reliable, keeps so many messages, and may be latched."""
    qos = Qos()
    depth = analysis.evaluator.fold(node, scope)
    if depth is not None and type(depth.value) is int and not depth.is_default:
        # Without an end.
        number = depth.value
        qos = Qos(history="keep_last", depth=number) if number else Qos(history="keep_all")
    if found.shape.kind is EndpointKind.PUBLISHER:
        qos = qos._replace(reliability="reliable")
        is_latched = _is_latched(analysis, found, scope)
        if is_latched is not None:
            qos = qos._replace(durability="transient_local" if is_latched else "volatile")
    return qos


def _is_latched(analysis: Analysis, found: Found, scope: Scope) -> bool | None:
    """Return what `advertise(topic, queue, latch)` or `advertise(…, callbacks, latch)` says."""
    at = found.shape.latch
    if found.options is not None:
        return _assigned_latch(analysis, found)
    given = found.arguments
    last = given[-1] if at is None or len(given) > at else None
    if last is None or len(given) < 3:
        return False
    value = analysis.evaluator.fold(last, scope)
    if value is not None and isinstance(value.value, bool):
        return None if value.is_default else value.value
    is_callback = last.type in (
        "call_expression",
        "lambda_expression",
        "pointer_expression",
        "this",
    )
    return False if is_callback or len(given) > 3 else None


def _assigned_latch(analysis: Analysis, found: Found) -> bool | None:
    name = last_name(found.call.arguments[0], found.call.scope)
    for node, path, right, scope in analysis.fields.of(name):
        if path == "latch" and node.start_byte < found.call.node.start_byte:
            value = analysis.evaluator.fold(right, scope)
            return value.value if value is not None and isinstance(value.value, bool) else None
    return False


def profile(analysis: Analysis, node: Node | None, scope: Scope, depth: int = 0) -> Qos | None:
    """Return the profile that an expression is, None for no profile that is known."""
    if node is None or depth > _MOST_DEEP:
        return None
    if node.type == "initializer_list":
        given = node.named_children
        return profile(analysis, given[0], scope, depth + 1) if len(given) == 1 else None
    number = analysis.evaluator.fold(node, scope)
    if number is not None:
        is_depth = type(number.value) is int and not number.is_default
        return DEFAULT._replace(depth=number.value if is_depth else None)  # type: ignore[arg-type]
    held = analysis.holding.of(node, scope)
    if held is None:
        return None
    found = _made(analysis, held, depth)
    if found is not None:
        for variable in reversed(held.variables):
            found = _changed(analysis, found, variable, node)
    return found


def _made(analysis: Analysis, held: Held, depth: int) -> Qos | None:
    scope, given = held.scope, held.arguments
    syntax = scope.file.syntax
    call = held.call
    if call is not None and call.receiver is not None:
        base = profile(analysis, call.receiver, scope, depth + 1)
        if call.name in ("get_rmw_qos_profile", "rmw_qos_profile"):
            return base
        return None if base is None else _step(analysis, base, call.name, call.arguments, scope)
    if not held.type:
        found = _RMW.fullmatch("".join(syntax.word(held.node).split()))
        return PROFILES.get(found[1].lower()) if found is not None else None
    if held.type in _CLASSES:
        return _initialized(analysis, _CLASSES[held.type], given, scope)
    if held.type == "rclcpp::QoSInitialization" and len(given) == 2:
        history = _policy(analysis, "history", given[0], scope)
        number = _policy(analysis, "depth", given[1], scope)
        return DEFAULT._replace(history=history, depth=number)  # type: ignore[arg-type]
    if held.type in ("rclcpp::QoS", "rclcpp::QoSInitialization::from_rmw"):
        if not given:
            return None
        base = DEFAULT
        if len(given) > 1:
            base = profile(analysis, given[1], scope, depth + 1) or Qos()
        text = syntax.word(given[0])
        if "from_rmw" in text:
            return base
        started = _initialized(analysis, base, given[:1], scope)
        if started is not None:
            return started
        return profile(analysis, given[0], scope, depth + 1)
    if held.type == "rclcpp::KeepLast" or held.type == "rclcpp::KeepAll":
        return _initialized(analysis, DEFAULT, (held.node,), scope)
    if held.type == "rmw_qos_profile_t" and len(given) == 1:
        return profile(analysis, given[0], scope, depth + 1)
    return None


def _initialized(
    analysis: Analysis, base: Qos, given: tuple[Node, ...], scope: Scope
) -> Qos | None:
    """Return a profile that `KeepLast(10)`, `KeepAll()` or a number begins."""
    if not given:
        return base
    held = analysis.holding.of(given[0], scope)
    if held is not None and held.type.endswith("KeepAll"):
        return base._replace(history="keep_all", depth=None)
    node, at = given[0], scope
    if held is not None and held.type.endswith("KeepLast"):
        if not held.arguments:
            return None
        node, at = held.arguments[0], held.scope
    value = analysis.evaluator.fold(node, at)
    if value is None or type(value.value) is not int:
        is_last = held is not None and held.type.endswith("KeepLast")
        is_named = held is not None and (bool(held.type) or held.node.type != "number_literal")
        if is_last:
            return base._replace(history="keep_last", depth=None)
        return None if is_named else base
    depth = None if value.is_default else value.value
    return base._replace(history="keep_last", depth=depth)


def _step(analysis: Analysis, qos: Qos, name: str, given: list[Node], scope: Scope) -> Qos | None:
    """Return a profile after a method that changes it."""
    if name in _WORDS:
        return qos.with_policy(*_WORDS[name])
    if name == "best_available":
        return qos._replace(reliability=BEST_AVAILABLE, durability=BEST_AVAILABLE)
    if name == "keep_all":
        return qos._replace(history="keep_all", depth=None)
    if name == "keep_last":
        value = analysis.evaluator.fold(given[0] if given else None, scope)
        is_known = value is not None and type(value.value) is int and not value.is_default
        depth = value.value if is_known and value is not None else None
        return qos._replace(history="keep_last", depth=depth)  # type: ignore[arg-type]
    if name in _POLICIES and given:
        return qos.with_policy(_POLICIES[name], _policy(analysis, name, given[0], scope))
    return None


def _policy(analysis: Analysis, name: str, node: Node, scope: Scope) -> object:
    """Return the value of a policy, None where it is not known."""
    if name in ("deadline", "lifespan", "liveliness_lease_duration"):
        value = seconds(analysis, node, scope)
        number = value.number if value is not None else None
        return float(number) if number is not None and math.isfinite(number) else None
    if name == "depth":
        value = analysis.evaluator.fold(node, scope)
        is_known = value is not None and type(value.value) is int
        return value.value if is_known and value is not None else None
    held = analysis.holding.of(node, scope)
    text = "".join(held.scope.file.syntax.word(held.node).split()) if held is not None else ""
    found = _POLICY.fullmatch(text.rpartition("::")[2])
    return _VALUES.get(found[1].replace("_", "").lower()) if found is not None else None


_Step = tuple[int, str, list[Node], Scope]


def _changed(analysis: Analysis, qos: Qos, variable: Variable, at: Node) -> Qos:
    """Return a profile as it is when a call is made, after what changes the variable with it."""
    steps = analysis.qos_steps.get(variable)
    if steps is None:
        steps = analysis.qos_steps[variable] = sorted(
            _steps(analysis, variable), key=lambda step: step[0]
        )
    if len(steps) > _MOST_CHANGES:
        return Qos()
    for start, name, given, scope in steps:
        changed = _step(analysis, qos, name, given, scope)
        if changed is None:
            continue
        # What only may run before the call leaves known what is the same with and without it.
        is_here = scope.enclosing("function") is variable.scope.enclosing("function")
        is_sure = variable.kind == "local" and (scope is variable.scope or _covers(scope, at))
        if is_here and start > at.start_byte and variable.kind == "local":
            continue
        qos = changed if is_sure or not is_here else qos.common(changed)
    return qos


def _steps(analysis: Analysis, variable: Variable) -> Iterator[_Step]:
    """Yield what changes the profile of a variable."""
    for name in (*_WORDS, *_POLICIES, "keep_last", "keep_all", "best_available"):
        for call in analysis.unit.calls.get(name, ()):
            if call.receiver is not None and _is_it(analysis, call.receiver, variable, call.scope):
                yield call.node.start_byte, name, call.arguments, call.scope
    for node, path, right, scope in analysis.fields.of(variable.name):
        left = node.child_by_field_name("left") if path in _POLICIES else None
        root = left.child_by_field_name("argument") if left is not None else None
        if root is not None and _is_it(analysis, root, variable, scope):
            yield node.start_byte, path, [right], scope


def _covers(scope: Scope, at: Node) -> bool:
    return scope.start <= at.start_byte < scope.end


def _is_it(analysis: Analysis, node: Node, variable: Variable, scope: Scope) -> bool:
    for _ in range(8):
        # `qos.reliable().keep_last(9)`
        callee = node.child_by_field_name("function") if node.type == "call_expression" else None
        inner = callee.child_by_field_name("argument") if callee is not None else None
        if inner is None:
            break
        node = inner
    name = last_name(node, scope)
    if name != variable.name:
        return False
    return analysis.unit.lookup(name, scope, node.start_byte) is variable
