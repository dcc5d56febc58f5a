"""What a test of a started node asks the ROS graph for."""

from __future__ import annotations

from typing import NamedTuple

from plastron_tui.model.kinds import EndpointKind
from plastron_tui.model.workspace import Node
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.ros.names import resolved_name


class Expected(NamedTuple):
    """What a node has in the graph: which kind of thing, its full name, and its type's."""

    kind: str
    name: str
    type: str


# Clients of ROS 1 are in no graph, and neither is an action as such: it is five topics.
_KINDS = {
    1: {
        EndpointKind.PUBLISHER: "publisher",
        EndpointKind.SUBSCRIPTION: "subscription",
        EndpointKind.SERVICE: "service",
    },
    2: {
        EndpointKind.PUBLISHER: "publisher",
        EndpointKind.SUBSCRIPTION: "subscription",
        EndpointKind.SERVICE: "service",
        EndpointKind.CLIENT: "client",
        EndpointKind.ACTION_SERVER: "action server",
        EndpointKind.ACTION_CLIENT: "action client",
    },
}

_INTERFACES = {
    EndpointKind.SERVICE: InterfaceKind.SERVICE,
    EndpointKind.CLIENT: InterfaceKind.SERVICE,
    EndpointKind.ACTION_SERVER: InterfaceKind.ACTION,
    EndpointKind.ACTION_CLIENT: InterfaceKind.ACTION,
}

# actionlib.action_server: what a server publishes and hears below the action's name.
_OF_ACTION_SERVER = (
    ("subscription", "goal"),
    ("subscription", "cancel"),
    ("publisher", "status"),
    ("publisher", "feedback"),
    ("publisher", "result"),
)
_OF_ACTION_CLIENT = tuple(
    ("publisher" if kind == "subscription" else "subscription", name)
    for kind, name in _OF_ACTION_SERVER
)


def expected_of(node: Node, ros_version: int) -> tuple[Expected, ...]:
    """Return what a node has once it runs, sorted; what is only guessed is left out.

    The types are spelled as the graph of ROS 2 does; in ROS 1 they are "", for nobody need know
    the type of a topic that nothing is sent to.
    """
    found = set()
    guesses = node.guesses
    for (kind, name), endpoint in node.endpoints.items():
        if (kind, name) in guesses or endpoint.type is None:
            continue
        full = resolved_name(node.name, name)
        if ros_version == 1 and kind in (EndpointKind.ACTION_SERVER, EndpointKind.ACTION_CLIENT):
            is_server = kind is EndpointKind.ACTION_SERVER
            for role, part in _OF_ACTION_SERVER if is_server else _OF_ACTION_CLIENT:
                found.add(Expected(role, f"{full}/{part}", ""))
        elif kind in _KINDS[ros_version]:
            type_ = endpoint.type
            folder = _INTERFACES.get(kind, InterfaceKind.MESSAGE).value
            spelled = f"{type_.package}/{folder}/{type_.name}" if ros_version == 2 else ""
            found.add(Expected(_KINDS[ros_version][kind], full, spelled))
    return tuple(sorted(found))
