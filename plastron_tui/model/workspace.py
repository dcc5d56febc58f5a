"""What a program builds: nodes, their endpoints, and the messages that they send.

The same endpoints describe a node that was created and one that was loaded from a file, so
that targets, panels and graphs see one kind of node.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Span

from .endpoints import (
    DEFAULT_RATE,
    Client,
    Endpoint,
    EndpointKey,
    EndpointKind,
    Message,
    Publication,
    Publisher,
    Service,
    Subscription,
)

if TYPE_CHECKING:
    from .source import SourceUnit

__all__ = [
    "DEFAULT_RATE",
    "Client",
    "Endpoint",
    "EndpointKey",
    "EndpointKind",
    "Generation",
    "Message",
    "Node",
    "Publication",
    "Publisher",
    "Service",
    "Subscription",
    "Workspace",
]


@dataclass(slots=True)
class Node:
    """A node, as the program has it so far.

    The four dictionaries are keyed by the graph name as it is written, in the order in which
    the endpoints came. `source` is the file that a loaded node came from, None for one that
    was created; `removed` says which statement took a name away last.
    """

    name: str
    variable: str
    span: Span
    library: str | None = None
    source: SourceUnit | None = None
    publishers: dict[str, Publisher] = field(default_factory=dict)
    subscriptions: dict[str, Subscription] = field(default_factory=dict)
    services: dict[str, Service] = field(default_factory=dict)
    clients: dict[str, Client] = field(default_factory=dict)
    removed: dict[str, Span] = field(default_factory=dict)

    @property
    def is_idle(self) -> bool:
        """Whether the node would do nothing."""
        return not (self.publishers or self.subscriptions or self.services or self.clients)

    @property
    def endpoints(self) -> dict[EndpointKey, Endpoint]:
        """The endpoints of all kinds, by kind and name."""
        kinds: dict[EndpointKind, Mapping[str, Endpoint]] = {
            EndpointKind.PUBLISHER: self.publishers,
            EndpointKind.SUBSCRIPTION: self.subscriptions,
            EndpointKind.SERVICE: self.services,
            EndpointKind.CLIENT: self.clients,
        }
        return {(kind, name): each for kind, found in kinds.items() for name, each in found.items()}

    @property
    def packages(self) -> frozenset[str]:
        """The packages whose interface types the node uses."""
        types = (endpoint.type for endpoint in self.endpoints.values())
        return frozenset(type_.package for type_ in types if type_ is not None)

    def snapshot(self) -> Node:
        """Return the node as it is now, untouched by what later statements do to it."""
        # `dataclasses.replace` takes four times as long, and a program may have thousands.
        return Node(
            self.name,
            self.variable,
            self.span,
            self.library,
            self.source,
            dict(self.publishers),
            dict(self.subscriptions),
            dict(self.services),
            dict(self.clients),
            self.removed,
        )


class Generation(NamedTuple):
    """A `generate_node`: the node as it was then, and the client library asked for."""

    node: Node
    library: str
    span: Span


@dataclass(slots=True)
class Workspace:
    """All that a program built, by variable, and what it asked to generate."""

    nodes: dict[str, Node] = field(default_factory=dict)
    messages: dict[str, Message] = field(default_factory=dict)
    generations: list[Generation] = field(default_factory=list)
