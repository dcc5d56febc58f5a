"""Whether all nodes of a program mean the same type by one topic, or one service."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from plastron_tui.diagnostics import Diagnostic, Label, codes, write
from plastron_tui.language.declaration import Statement
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName
from plastron_tui.ros.names import resolved_name

from .kinds import Endpoint, EndpointKind, kind_of
from .workspace import Node

CONFLICTS = {
    InterfaceKind.MESSAGE: codes.TOPIC_TYPE_CONFLICT,
    InterfaceKind.SERVICE: codes.SERVICE_TYPE_CONFLICT,
    InterfaceKind.ACTION: codes.ACTION_TYPE_CONFLICT,
}

_User = tuple[str, EndpointKind]
_Place = tuple[InterfaceKind | None, int, str]
"""What is meant: a topic (or a service), in a generation of ROS, by its full name."""


@dataclass(slots=True)
class _Use:
    type: InterfaceName
    users: dict[_User, Statement]
    holder: object
    """Who may change it; for others it is a value."""


class Agreements:
    """The types of the topics and of the services that are in use, and who uses each.

    ROS 1 and ROS 2 are two graphs: what one means by a topic is nothing to the other.
    """

    def __init__(self) -> None:
        """Start with nothing in use."""
        self._uses: dict[_Place, _Use] = {}
        # Not this object itself: it would be a cycle, and the collector works seldom.
        self._holder = object()

    def fork(self) -> Agreements:
        """Return the same once more: what happens to the one is nothing to the other."""
        other = Agreements()
        other._uses = dict(self._uses)
        self._holder = object()
        return other

    def _own(self, place: _Place, use: _Use) -> _Use:
        if use.holder is not self._holder:
            use = self._uses[place] = _Use(use.type, dict(use.users), self._holder)
        return use

    def join(
        self, node: Node, version: int, endpoint: Endpoint, statement: Statement
    ) -> Diagnostic | None:
        """Note that a node uses a name; return what is wrong if others use another type."""
        kind = kind_of(type(endpoint))
        place = _place(node, version, kind, endpoint.name)
        use = self._uses.get(place)
        if use is None:
            assert isinstance(endpoint.type, InterfaceName)
            use = self._uses[place] = _Use(endpoint.type, {}, self._holder)
        elif use.type != endpoint.type:
            return _conflict(use, endpoint, kind, statement)
        else:
            use = self._own(place, use)
        use.users.setdefault((node.variable, kind), statement)
        return None

    def conflict(
        self, node: Node, version: int, endpoint: Endpoint, statement: Statement
    ) -> Diagnostic | None:
        """Return what is wrong if others use a name for another type than an endpoint's."""
        kind = kind_of(type(endpoint))
        use = self._uses.get(_place(node, version, kind, endpoint.name))
        if use is None or use.type == endpoint.type:
            return None
        return _conflict(use, endpoint, kind, statement)

    def adopt(self, node: Node, version: int, statement: Statement) -> None:
        """Note what a file holds; whether files agree is seen at the end (`meetings.py`)."""
        for endpoint in node.endpoints.values():
            if isinstance(endpoint.type, InterfaceName):
                self.join(node, version, endpoint, statement)

    def other(
        self, node: Node, version: int, endpoint: Endpoint, nodes: Mapping[str, Node]
    ) -> Statement | None:
        """Return the statement by which another node has an endpoint of a kind and name, if any."""
        kind = kind_of(type(endpoint))
        use = self._uses.get(_place(node, version, kind, endpoint.name))
        if use is None:
            return None
        for (variable, other_kind), where in use.users.items():
            # A node that was loaded again is not another one.
            if other_kind is kind and nodes[variable].name != node.name:
                return where
        return None

    def leave(self, node: Node, version: int, kind: EndpointKind, name: str) -> None:
        """Note that a node uses a name no longer; a name that nobody uses is free again."""
        place = _place(node, version, kind, name)
        use = self._uses.get(place)
        if use is None:
            return
        use = self._own(place, use)
        use.users.pop((node.variable, kind), None)
        if not use.users:
            del self._uses[place]


def _conflict(
    use: _Use, endpoint: Endpoint, kind: EndpointKind, statement: Statement
) -> Diagnostic:
    facts = kind.facts
    elsewhere = next(iter(use.users.values())).span
    where = statement.span_of("type")
    # A message or a request with values is of one type only: they would not fit another.
    fix = None if facts.sends else write(str(use.type), where)
    assert facts.interface is not None
    return Diagnostic(
        CONFLICTS[facts.interface],
        f"{facts.named} `{endpoint.name}` is of type `{use.type}` elsewhere in this program",
        where,
        help=f"use `{use.type}` here too, or another {facts.named}",
        fix=fix,
        labels=(Label(elsewhere, f"`{use.type}` here"),),
    )


def _place(node: Node, version: int, kind: EndpointKind, name: str) -> _Place:
    return kind.facts.interface, version, resolved_name(node.name, name)
