"""What a program builds: nodes, their endpoints, and the messages that they send.

The same endpoints describe a node that was created and one that was loaded from a file, so
that targets, panels and graphs see one kind of node.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from enum import Enum
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Span
from plastron_tui.ros.interfaces import InterfaceName

if TYPE_CHECKING:
    from .source import SourceFile
    from .values import MessageValue

DEFAULT_RATE = 10.0
"""How often a message is published where the program does not say, in hertz."""


class EndpointKind(str, Enum):
    """What a call site creates. The values are the keys of `plastron inspect --format json`."""

    PUBLISHER = "publishers"
    SUBSCRIPTION = "subscriptions"
    SERVICE = "services"
    CLIENT = "clients"
    ACTION_SERVER = "action_servers"
    ACTION_CLIENT = "action_clients"
    TIMER = "timers"
    PARAMETER = "parameters"


class Message(NamedTuple):
    """A message that a program created, under its variable's name."""

    variable: str
    value: MessageValue
    span: Span


class Publication(NamedTuple):
    """One message on its way to a topic, and how often it is sent, in hertz.

    `is_rate_open` tells that the program leaves the rate to Plastron, or to the loop of a file
    that has one; `rate` is then the default.
    """

    message: Message
    rate: float
    span: Span | None = None
    is_rate_open: bool = False


class Publisher(NamedTuple):
    """A topic that a node publishes; `publications` is empty for one that was read from a file."""

    topic: str
    type: InterfaceName | None
    publications: tuple[Publication, ...] = ()
    span: Span | None = None


class Subscription(NamedTuple):
    """A topic that a node listens to; without a `callback` the target names one."""

    topic: str
    type: InterfaceName | None
    callback: str | None = None
    span: Span | None = None


class Service(NamedTuple):
    """A service that a node provides; without a `handler` the target names one."""

    name: str
    type: InterfaceName | None
    handler: str | None = None
    span: Span | None = None


class Client(NamedTuple):
    """A service that a node calls, with the request of each call, in order."""

    name: str
    type: InterfaceName | None
    requests: tuple[MessageValue, ...] = ()
    span: Span | None = None


Endpoint = Publisher | Subscription | Service | Client
EndpointKey = tuple[EndpointKind, str]
"""What an endpoint is known by: its kind, and its graph name as it is written."""


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
    source: SourceFile | None = None
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
        return replace(
            self,
            publishers=dict(self.publishers),
            subscriptions=dict(self.subscriptions),
            services=dict(self.services),
            clients=dict(self.clients),
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
