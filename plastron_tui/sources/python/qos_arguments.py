"""The quality of service that a program asks for, as an argument of a call.

Source: `rclpy.qos` of Jazzy (profiles, policies, defaults), `rospy.topics` of Noetic.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from plastron_tui.model.kinds import Endpoint, Publisher, Subscription
from plastron_tui.ros.qos import DEFAULT, PROFILES, Qos

from . import literals
from .addition import Addition
from .analysis import Site
from .calls import Argument
from .replacing import NotInPlaceError, Replacement
from .splices import Splice
from .syntax import parts_of

_POLICIES = {
    "reliability": "ReliabilityPolicy",
    "durability": "DurabilityPolicy",
    "history": "HistoryPolicy",
    "liveliness": "LivelinessPolicy",
}
_FIELDS = {"lease": "liveliness_lease_duration"}
_DEPTH = 10
# What is sent once is kept for those who listen later.
_KEPT = Qos(durability="transient_local", depth=1)


def asked_qos(endpoint: Endpoint) -> Qos | None:
    """Return the quality of service that a program asks for, None where it asks for none."""
    if not isinstance(endpoint, Publisher | Subscription) or endpoint.span is None:
        return None
    sent = endpoint.publications if isinstance(endpoint, Publisher) else ()
    if any(each.is_once for each in sent):
        return (endpoint.qos or Qos()).over(_KEPT)
    return endpoint.qos


def profile(qos: Qos, use: Callable[[str, str], str]) -> str:
    """Write a profile for rclpy: a depth alone, one of its own profiles, or a new one.

    Args:
        qos: the policies; what is not known is as ROS 2 has it.
        use: brings a name of a module into the file, and returns what the file calls it.
    """
    full = qos.over(DEFAULT)
    for name in ("sensor_data", "system_default"):
        if full == PROFILES[name]:
            return use("rclpy.qos", f"qos_profile_{name}")
    said = {name: value for name, value in full.known.items() if value != getattr(DEFAULT, name)}
    depth = said.pop("depth", _DEPTH)
    if not said and depth:
        return str(depth)
    given = [] if full.history == "keep_all" else [f"depth={depth}"]
    for name, value in said.items():
        given.append(f"{_FIELDS.get(name, name)}={_policy(name, value, use)}")
    return f"{use('rclpy.qos', 'QoSProfile')}({', '.join(given)})"


def _policy(name: str, value: str | float, use: Callable[[str, str], str]) -> str:
    if isinstance(value, str):
        return f"{use('rclpy.qos', _POLICIES[name])}.{value.upper()}"
    duration = use("rclpy.duration", "Duration")
    if value == math.inf:
        return f"{duration}.infinite"  # pragma: no cover - the default, which is not said
    return f"{duration}(seconds={literals.number(int(value) if value % 1 == 0 else value)})"


def has_policies(endpoint: Endpoint, found: Qos | None, version: int) -> bool:
    """Tell whether a call gives all policies that are asked for, those of its ROS at least."""
    asked = asked_qos(endpoint)
    if asked is None:
        return True
    there = found or Qos()
    wanted = asked.over(DEFAULT).known if asked.history == "keep_all" else asked.known
    if version == 1:
        # It is reliable in all cases, and keeps messages for who comes later where it is latched.
        wanted = {name: wanted[name] for name in ("depth", "durability") if name in wanted}
        if there.durability is None:
            wanted.pop("durability", None)
    return all(getattr(there, name) == value for name, value in wanted.items())


def ros1_arguments(qos: Qos, endpoint: Endpoint) -> dict[str, str]:
    """Return the keywords of rospy that say what it has of a quality of service."""
    given = {}
    if qos.depth:
        given["queue_size"] = str(qos.depth)
    if isinstance(endpoint, Publisher) and qos.durability is not None:
        given["latch"] = repr(qos.durability == "transient_local")
    return given


def requalify(update: Replacement) -> None:
    """Change the quality of service of a call where another one is asked for.

    Raises:
        NotInPlaceError: the call does not say it itself.
    """
    added, site = update.added, update.site
    qos = asked_qos(added.endpoint)
    if qos is None or has_policies(added.endpoint, site.endpoint.qos, added.dialect.ros_version):
        return
    places = site.shape.qos
    if places is None or site.arguments.is_open:
        raise NotInPlaceError
    if not added.is_rclpy:
        for keyword, value in ros1_arguments(qos, added.endpoint).items():
            place = places.queue_size if keyword == "queue_size" else places.latch
            if place is not None and (keyword != "latch" or value == "True" or _has(site, place)):
                put_argument(update, place, value)
        return
    if places.profile is None:
        raise NotInPlaceError
    if qos.depth is None and qos.history is None and site.endpoint.qos is not None:
        qos = qos._replace(depth=site.endpoint.qos.depth)
    put_argument(update, places.profile, profile(qos, added.imports.use))


def _has(site: Site, place: Argument) -> bool:
    return site.arguments.get(place) is not None


def put_argument(update: Replacement, argument: Argument, text: str) -> None:
    """Replace an argument of a call, or give it one more.

    Raises:
        NotInPlaceError: nobody knows where it would go.
    """
    given = update.site.arguments.get(argument)
    if given is not None:
        update.put(given, text)
        return
    listed = update.site.call.child_by_field_name("arguments")
    parts = parts_of(listed)
    if not parts or update.site.arguments.is_open:
        raise NotInPlaceError
    end = parts[-1].end_byte
    written = f", {argument.keyword}={text}"
    update.splices.append(Splice(end, end, update.analysis.syntax.encode(written)))


def creation_qos(added: Addition) -> list[tuple[str, str]]:
    """Return the keywords of a new call that say its quality of service; none for none asked."""
    qos = asked_qos(added.endpoint)
    if qos is None:
        return []
    if added.is_rclpy:
        return [("qos_profile", profile(qos, added.imports.use))]
    found = ros1_arguments(qos, added.endpoint)
    if isinstance(added.endpoint, Publisher):
        found = {"queue_size": str(_DEPTH), **found}
    return [(name, value) for name, value in found.items() if value != "False"]
