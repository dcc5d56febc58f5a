"""Quality of service, written as the client libraries take it.

Source: `rclpy.qos` of Jazzy (profiles, policies, their order, defaults), `rospy.topics` of Noetic.
"""

from __future__ import annotations

from collections.abc import Callable

from plastron_tui.ros.qos import DEFAULT, PROFILES, Qos
from plastron_tui.ros.qos_words import latch_of

from . import literals

_NAMED = ("sensor_data", "system_default")
"""The profiles that rclpy has objects of, which are written by name where nothing else is said."""

_ORDER = (
    *("history", "depth", "reliability", "durability"),
    *("deadline", "lifespan", "liveliness", "lease"),
)
"""The policies in the order in which `rclpy.qos.QoSProfile` takes them."""

_KEYWORDS = {"lease": "liveliness_lease_duration"}


def profile(qos: Qos, use: Callable[[str, str], str]) -> str:
    """Write a profile for rclpy: a depth alone, one of its own profiles, or a new one.

    Args:
        qos: the policies; what is not known is as ROS 2 has it.
        use: brings a name of a module into the file, and returns what the file calls it.
    """
    full = qos.over(DEFAULT)
    for name in _NAMED:
        if full == PROFILES[name]:
            return use("rclpy.qos", f"qos_profile_{name}")
    # A profile that keeps all has no depth; every other one needs it.
    said = {
        policy: full.known[policy]
        for policy in _ORDER
        if policy in full.known
        and (policy == "depth" or full.known[policy] != getattr(DEFAULT, policy))
    }
    if [*said] == ["depth"]:
        return str(full.depth)
    given = (f"{_KEYWORDS.get(name, name)}={_policy(name, said[name], use)}" for name in said)
    return f"{use('rclpy.qos', 'QoSProfile')}({', '.join(given)})"


def _policy(policy: str, value: str | float, use: Callable[[str, str], str]) -> str:
    if policy == "depth":
        return str(value)
    if isinstance(value, str):
        return f"{use('rclpy.qos', f'{policy.title()}Policy')}.{value.upper()}"
    # No limit is the default of every duration, which is not said.
    seconds = literals.number(int(value) if value % 1 == 0 else value)
    return f"{use('rclpy.duration', 'Duration')}(seconds={seconds})"


def keywords(qos: Qos, *, is_publisher: bool) -> dict[str, str]:
    """Return the keywords of rospy that say what it has of a quality of service."""
    found = {"queue_size": str(qos.depth)} if qos.depth else {}
    latch = latch_of(qos) if is_publisher else None
    return found if latch is None else {**found, "latch": repr(latch)}


def new_keywords(qos: Qos | None, *, is_publisher: bool) -> dict[str, str]:
    """Return the keywords of a new call of rospy: a publisher has a queue in any case.

    A subscription of ROS 1 keeps all messages unless it is told how many.
    """
    found = keywords(qos or Qos(), is_publisher=is_publisher)
    if is_publisher:
        found = {"queue_size": str(DEFAULT.depth), **found}
    return {name: value for name, value in found.items() if value != "False"}
