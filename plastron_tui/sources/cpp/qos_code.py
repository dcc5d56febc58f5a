"""Quality of service, written as the client libraries for C++ take it.

Source: `rclcpp/qos.hpp` of Jazzy (profiles, setters), `ros/advertise_options.h` of Noetic.
"""

from __future__ import annotations

from plastron_tui.ros.qos import DEFAULT, PROFILES, SYSTEM_DEFAULT, Qos
from plastron_tui.ros.qos_words import latch_of

from . import literals

_NAMED = {"sensor_data": "rclcpp::SensorDataQoS()", "system_default": "rclcpp::SystemDefaultsQoS()"}

_DURATIONS = {"deadline": "deadline", "lifespan": "lifespan", "lease": "liveliness_lease_duration"}
_SETTERS = {
    ("reliability", "best_effort"): "best_effort",
    ("reliability", "reliable"): "reliable",
    ("durability", "volatile"): "durability_volatile",
    ("durability", "transient_local"): "transient_local",
}


def profile(qos: Qos) -> str:
    """Write a profile for rclcpp: a depth alone, one of its own profiles, or a new one."""
    full = qos.over(DEFAULT)
    for name, written in _NAMED.items():
        if full == PROFILES[name]:
            return written
    if full == DEFAULT._replace(depth=full.depth) and full.depth is not None:
        return str(full.depth)
    depth = DEFAULT.depth if full.depth is None else full.depth
    text = (
        "rclcpp::QoS(rclcpp::KeepAll())" if full.history == "keep_all" else f"rclcpp::QoS({depth})"
    )
    for policy, value in full.known.items():
        if policy in {"depth", "history"} or value == getattr(DEFAULT, policy):
            continue
        text += f".{_setter(policy, value)}"
    return text


def _setter(policy: str, value: str | float) -> str:
    if not isinstance(value, str):
        return (
            f"{_DURATIONS[policy]}(rclcpp::Duration::from_seconds({literals.real(float(value))}))"
        )
    known = _SETTERS.get((policy, value))
    if known is not None:
        return f"{known}()"
    word = "SystemDefault" if value == SYSTEM_DEFAULT else value.title().replace("_", "")
    return f"{policy}(rclcpp::{policy.title()}Policy::{word})"


def latch(qos: Qos | None, *, is_publisher: bool) -> str:
    """Write the size of a queue for roscpp, and whether a publisher latches.

    A subscription of ROS 1 keeps all messages unless it is told how many: a queue of 0.
    """
    known = qos or Qos()
    depth = known.depth if known.depth else (DEFAULT.depth if is_publisher else 0)
    is_latched = is_publisher and latch_of(known) is True
    return f"{depth}, true" if is_latched else str(depth)
