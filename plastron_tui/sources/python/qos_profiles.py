"""The profiles of quality of service that expressions of a file are, and the values of policies.

Source: `rclpy.qos` and `rclpy.duration` of Jazzy, with the names of older distributions that they
still have.
"""

from __future__ import annotations

import math
import re

from tree_sitter import Node

from plastron_tui.ros.qos import BEST_AVAILABLE, DEFAULT, PROFILES, SYSTEM_DEFAULT, Qos

from .analysis import Analysis
from .arguments import Arguments
from .calls import Argument
from .constants import Known
from .origins import Origin, constant, integer, origins
from .scopes import Scope

Value = str | int | float | None
"""The value of a policy, None where it is not known."""

FIELDS = {
    "history": "history",
    "depth": "depth",
    "reliability": "reliability",
    "durability": "durability",
    "lifespan": "lifespan",
    "deadline": "deadline",
    "liveliness": "liveliness",
    "liveliness_lease_duration": "lease",
}
"""The arguments of a `QoSProfile`, in their order, and what a `Qos` calls them."""

_PROFILE = re.compile(r"rclpy\..*\bqos_profile_(\w+)|rclpy\..*\bQoSPresetProfiles\.(\w+)\.value")
_PRESET = re.compile(r"rclpy\..*\bQoSPresetProfiles\.get_from_short_key")
_MADE = re.compile(r"rclpy\.(?:.*\.)?QoSProfile")
_COPIED = frozenset({"copy.copy", "copy.deepcopy"})
_DURATION = re.compile(r"rclpy\.(?:.*\.)?Duration")
_POLICY = re.compile(
    r"rclpy\.(?:.*\.)?(?:QoS)?(?:History|Reliability|Durability|Liveliness)Policy\."
    r"(?:RMW_QOS_POLICY_(?:HISTORY|RELIABILITY|DURABILITY|LIVELINESS)_)?(\w+?)(?:\.value)?"
)
_SHORT_KEY = "get_from_short_key"
# The numbers of `rmw/types.h`.
_POLICIES = {
    "history": {0: SYSTEM_DEFAULT, 1: "keep_last", 2: "keep_all"},
    "reliability": {
        0: SYSTEM_DEFAULT,
        1: "reliable",
        2: "best_effort",
        4: BEST_AVAILABLE,
    },
    "durability": {
        0: SYSTEM_DEFAULT,
        1: "transient_local",
        2: "volatile",
        4: BEST_AVAILABLE,
    },
    "liveliness": {
        0: SYSTEM_DEFAULT,
        1: "automatic",
        3: "manual_by_topic",
        5: BEST_AVAILABLE,
    },
}
_INFINITE = 2**63 - 1
"""The nanoseconds of a duration without an end."""


def made_by(origin: Origin) -> Qos | None:
    """Return the profile that something makes, None for anything else."""
    node = origin.node
    if node is None:
        named = _PROFILE.fullmatch(origin.name)
        return PROFILES.get((named[1] or named[2]).lower()) if named is not None else None
    if node.type != "call":
        depth = integer(origin.analysis, node, origin.scope)
        return DEFAULT._replace(depth=depth) if depth is not None else None
    names = _callee(origin)
    arguments = Arguments.of(node, origin.analysis.syntax)
    if any(map(_MADE.fullmatch, names)):
        return _made(origin, arguments)
    if any(map(_PRESET.fullmatch, names)):
        return PROFILES.get(_text(origin, arguments).lower())
    return None


def copied(origin: Origin) -> Node | None:
    """Return the profile that a call copies, None for anything else."""
    if origin.node is None or origin.node.type != "call" or _COPIED.isdisjoint(_callee(origin)):
        return None
    return Arguments.of(origin.node, origin.analysis.syntax).get(Argument(0, "x"))


def _callee(origin: Origin) -> tuple[str, ...]:
    callee = origin.node.child_by_field_name("function") if origin.node is not None else None
    return origin.analysis.resolver.qualified(callee, origin.scope)


def _text(origin: Origin, arguments: Arguments) -> str:
    """Return the one argument of a call, "" where it is no text that the file says."""
    folded = origin.analysis.resolver.fold(arguments.get(Argument(0, "name")), origin.scope)
    return str(folded.value) if isinstance(folded, Known) else ""


def _made(origin: Origin, arguments: Arguments) -> Qos:
    """Return what `QoSProfile(…)` makes: what it does not say is as in the default profile."""
    found = DEFAULT
    for position, (argument, field) in enumerate(FIELDS.items()):
        given = arguments.get(Argument(position, argument))
        if given is not None and given.type != "none":
            value = policy(field, origin.analysis, given, origin.scope)
            found = found.with_policy(field, value)
        elif arguments.is_open:
            found = found.with_policy(field, None)
    return found


def policy(field: str, analysis: Analysis, node: Node, scope: Scope) -> Value:
    """Return the value that an expression gives a policy, None where it is not known."""
    read = _enum if field in _POLICIES else _depth if field == "depth" else _seconds
    values = {read(field, each) for each in origins(analysis, node, scope) or ()}
    return values.pop() if len(values) == 1 else None


def _enum(field: str, origin: Origin) -> str | None:
    name = ""
    if origin.node is None:
        name = origin.name
    elif origin.node.type == "call":
        key = _text(origin, Arguments.of(origin.node, origin.analysis.syntax))
        callees = (each.removesuffix(_SHORT_KEY) for each in _callee(origin))
        name = next((f"{each}{key}" for each in callees if each.endswith("Policy.")), "")
    else:
        number = integer(origin.analysis, origin.node, origin.scope)
        return None if number is None else _POLICIES[field].get(number)
    found = _POLICY.fullmatch(name)
    value = "" if found is None else found[1].lower()
    return value if value in _POLICIES[field].values() else None


def _depth(field: str, origin: Origin) -> int | None:
    return integer(origin.analysis, origin.node, origin.scope)


def _seconds(field: str, origin: Origin) -> float | None:
    """Return the seconds of `Duration(…)`; none of them, and the most of them, are no limit."""
    if origin.node is None:
        return math.inf if origin.name == "rclpy.duration.Infinite" else None
    if origin.node.type != "call" or not any(map(_DURATION.fullmatch, _callee(origin))):
        return None
    arguments = Arguments.of(origin.node, origin.analysis.syntax)
    if arguments.is_open:
        return None
    nanoseconds = 0
    for name, scale in (("seconds", 10**9), ("nanoseconds", 1)):
        given = arguments.get(Argument(-1, name))
        number = constant(origin.analysis, given, origin.scope) if given is not None else 0
        if number is None or not math.isfinite(number):
            return None
        # rclpy cuts what is below a nanosecond off: 2.01 is what somebody wrote all the same.
        nanoseconds += round(number * scale)
    return nanoseconds / 10**9 if 0 < nanoseconds < _INFINITE else math.inf
