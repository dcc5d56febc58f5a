"""Quality of service: the policies of a topic, and which of them match.

Sources: the ROS 2 documentation "Quality of Service settings" (policies, profiles, and which of
them are compatible); `rmw/qos_profiles.h`, `rmw/types.h` and `rcl_action/default_qos.h` of Jazzy
(values of the profiles).
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from functools import reduce
from types import MappingProxyType
from typing import Any, NamedTuple

SYSTEM_DEFAULT = "system_default"
"""The value of a policy that is left to the middleware."""

BEST_AVAILABLE = "best_available"
"""The value of a policy that is chosen to match what is there when the endpoint is created."""


class Qos(NamedTuple):
    """The quality of service of a publisher or a subscription.

    A policy is None where it is not known, or where a program does not say it.

    Attributes:
        reliability: `reliable`, `best_effort`, or one of `SYSTEM_DEFAULT`, `BEST_AVAILABLE`.
        durability: `volatile`, `transient_local`, or one of these two.
        history: `keep_last`, `keep_all`, or `SYSTEM_DEFAULT`.
        depth: how many messages are kept, None also where all are; 0: as the middleware likes.
        deadline: the most seconds between two messages, `math.inf` for no limit.
        lifespan: after how many seconds a message is too old, `math.inf` for never.
        liveliness: `automatic`, `manual_by_topic`, or one of `SYSTEM_DEFAULT`, `BEST_AVAILABLE`.
        lease: within how many seconds a publisher shows that it lives, `math.inf` for no limit.
    """

    reliability: str | None = None
    durability: str | None = None
    history: str | None = None
    depth: int | None = None
    deadline: float | None = None
    lifespan: float | None = None
    liveliness: str | None = None
    lease: float | None = None

    def over(self, base: Qos) -> Qos:
        """Return these policies, with those of `base` where there are none."""
        found = Qos._make(b if a is None else a for a, b in zip(self, base, strict=True))
        return found._replace(depth=None) if found.history == "keep_all" else found

    def common(self, other: Qos) -> Qos:
        """Return the policies that are the same in both."""
        return Qos._make(a if a == b else None for a, b in zip(self, other, strict=True))

    def with_policy(self, policy: str, value: Any) -> Qos:
        """Return the policies with another value of the one of a name."""
        return self._replace(**{policy: value})

    @property
    def known(self) -> dict[str, Any]:
        """The policies that are known, by name."""
        pairs = zip(self._fields, self, strict=True)
        return {policy: value for policy, value in pairs if value is not None}


def common(found: Iterable[Qos | None]) -> Qos | None:
    """Return the policies that are the same in all of one or more, None where there are none."""
    same = reduce(Qos.common, (each or Qos() for each in found))
    return same if same.known else None


def _kept(reliability: str, durability: str, depth: int, lifespan: float = math.inf) -> Qos:
    kept = reliability, durability, "keep_last", depth
    return Qos(*kept, math.inf, lifespan, SYSTEM_DEFAULT, math.inf)


PROFILES: Mapping[str, Qos] = MappingProxyType(
    {
        "default": _kept("reliable", "volatile", 10),
        "sensor_data": _kept("best_effort", "volatile", 5),
        "system_default": _kept(SYSTEM_DEFAULT, SYSTEM_DEFAULT, 0)._replace(history=SYSTEM_DEFAULT),
        "services_default": _kept("reliable", "volatile", 10),
        "parameters": _kept("reliable", "volatile", 1000),
        "parameter_events": _kept("reliable", "volatile", 1000),
        "action_status_default": _kept("reliable", "transient_local", 1),
        "rosout_default": _kept("reliable", "transient_local", 1000, lifespan=10.0),
        # Deadline and lease are those of whom it meets.
        "best_available": Qos(
            *(BEST_AVAILABLE, BEST_AVAILABLE, "keep_last", 10),
            lifespan=math.inf,
            liveliness=BEST_AVAILABLE,
        ),
    }
)
"""The profiles that ROS 2 has by name."""

DEFAULT = PROFILES["default"]
"""What a publisher or a subscription of ROS 2 has where a program says nothing else."""


def value_text(value: str | float) -> str:
    """Return the value of a policy for people; that of a duration has its unit."""
    if isinstance(value, str):
        return value
    return "infinite" if value == math.inf else f"{value:.15g} s"


class Mismatch(NamedTuple):
    """A policy by which a publisher and a subscription never match.

    Attributes:
        policy: the field of `Qos`.
        offered: what the publisher has.
        requested: what the subscription has.
    """

    policy: str
    offered: str | float
    requested: str | float


# The values of a policy, from what promises less to what promises more.
_PROMISES = {
    "reliability": ("best_effort", "reliable"),
    "durability": ("volatile", "transient_local"),
    "liveliness": ("automatic", "manual_by_topic"),
}
_DURATIONS = ("deadline", "lease")


def mismatches(offered: Qos, requested: Qos) -> tuple[Mismatch, ...]:
    """Return the policies by which a publisher and a subscription never match.

    A publisher has to promise no less than the subscription asks for: reliability, durability and
    liveliness that are as strong, a deadline and a lease that are as short. What is not known, or
    left to the middleware, is no reason.

    Args:
        offered: what the publisher has.
        requested: what the subscription has.
    """
    return tuple(_mismatches(offered, requested))


def _mismatches(offered: Qos, requested: Qos) -> Iterator[Mismatch]:
    for policy in Qos._fields:
        has, wants = getattr(offered, policy), getattr(requested, policy)
        if policy in _PROMISES:
            order = _PROMISES[policy]
            is_short = has in order and wants in order and order.index(has) < order.index(wants)
        else:
            is_known = policy in _DURATIONS and has is not None and wants is not None
            is_short = is_known and has > wants
        if is_short:
            yield Mismatch(policy, has, wants)
