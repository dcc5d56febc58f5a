"""Quality of service, as the calls of a client library take it."""

from __future__ import annotations

import math

from plastron_tui.ros.qos import DEFAULT, PROFILES, Qos
from plastron_tui.ros.qos_words import WORDS
from plastron_tui.sources.python import literals

from .writing import Writing

_PROFILES = {
    "sensor_data": "qos_profile_sensor_data",
    "system_default": "qos_profile_system_default",
}
"""The profiles that rclpy has objects of, which are written by name where nothing else is said."""

_POLICIES = {
    "history": ("history", "HistoryPolicy"),
    "reliability": ("reliability", "ReliabilityPolicy"),
    "durability": ("durability", "DurabilityPolicy"),
    "liveliness": ("liveliness", "LivelinessPolicy"),
}
_DURATIONS = {
    "deadline": "deadline",
    "lifespan": "lifespan",
    "lease": "liveliness_lease_duration",
}
_LATCHED = WORDS["latched"].says
"""What ROS 1 has a word for: its latch."""

_ORDER = (
    *("history", "depth", "reliability", "durability"),
    *("deadline", "lifespan", "liveliness", "lease"),
)
"""The policies in the order in which `rclpy.qos.QoSProfile` takes them."""


def publisher_qos(writing: Writing, qos: Qos | None) -> str:
    """Write what a publisher is given besides its topic and its type."""
    if writing.is_rclpy:
        return _rclpy(writing, qos)
    # A depth of 0 leaves it to the middleware of ROS 2; here it would keep messages without end.
    depth = (qos and qos.depth) or DEFAULT.depth
    is_kept = qos is not None and qos.common(_LATCHED) == _LATCHED
    return f"queue_size={depth}{', latch=True' if is_kept else ''}"


def subscription_qos(writing: Writing, qos: Qos | None) -> str:
    """Write what a subscription is given behind its callback, "" for nothing."""
    if writing.is_rclpy:
        return _rclpy(writing, qos)
    # A subscription of ROS 1 keeps all messages unless it is told how many.
    return f"queue_size={qos.depth}" if qos is not None and qos.depth else ""


def _rclpy(writing: Writing, qos: Qos | None) -> str:
    """Write a profile: a depth alone, one that has a name, or what differs from the default."""
    meant = DEFAULT if qos is None else qos.over(DEFAULT)
    for profile, name in _PROFILES.items():
        if meant == PROFILES[profile].over(DEFAULT):
            return writing.imports.use("rclpy.qos", name)
    different = [
        policy
        for policy in _ORDER
        if getattr(meant, policy) not in (None, getattr(DEFAULT, policy)) or policy == "depth"
    ]
    if different == ["depth"]:
        return str(meant.depth)
    # A profile that keeps all has no depth; every other one needs it.
    given = (
        _policy(writing, policy, getattr(meant, policy))
        for policy in different
        if policy != "depth" or meant.depth is not None
    )
    return f"{writing.imports.use('rclpy.qos', 'QoSProfile')}({', '.join(given)})"


def _policy(writing: Writing, policy: str, value: str | float) -> str:
    if policy == "depth":
        return f"depth={value}"
    if policy in _DURATIONS:
        assert not isinstance(value, str)
        return f"{_DURATIONS[policy]}={_duration(writing, value)}"
    name, class_ = _POLICIES[policy]
    return f"{name}={writing.imports.use('rclpy.qos', class_)}.{str(value).upper()}"


def _duration(writing: Writing, seconds: float) -> str:
    class_ = writing.imports.use("rclpy.duration", "Duration")
    if seconds == math.inf:
        return f"{class_}()"
    number = int(seconds) if float(seconds).is_integer() else seconds
    return f"{class_}(seconds={literals.number(number)})"
