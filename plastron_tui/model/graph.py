"""The graph of a workspace: which nodes meet on which topics and services.

It is the data behind `plastron graph` and the panels: complete, in the order of the program,
and each entry with the span of the statement that it comes from.
"""

from __future__ import annotations

from enum import Enum
from pathlib import Path
from typing import Any, NamedTuple

from plastron_tui.diagnostics import Span
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.ros.names import resolved_name

from .kinds import Client, Publication, Publisher, Service, Subscription
from .values import MessageValue
from .workspace import Node, Workspace


class Missing(str, Enum):
    """The side of a topic or service that no node of the program takes."""

    PUBLISHER = "publisher"
    SUBSCRIBER = "subscriber"
    PROVIDER = "provider"
    CLIENT = "client"


class GraphNode(NamedTuple):
    """A node; its variable is what tells it from the others.

    Attributes:
        name: the node's name, as the program or the file has it.
        variable: the program's variable for it.
        library: the client library; for a created node that names none, the one that it was
            last generated for; None where neither says it.
        file: the file that a loaded node came from, None for a created one.
        is_generated: whether the program generates it.
        span: the statement that created or loaded it.
    """

    name: str
    variable: str
    library: str | None
    file: Path | None
    is_generated: bool
    span: Span

    @property
    def is_loaded(self) -> bool:
        """Whether the node was read from a file."""
        return self.file is not None


class Sending(NamedTuple):
    """A message that goes to a topic: its variable, and how often, in hertz."""

    message: str
    rate: float
    span: Span | None


class TopicPublisher(NamedTuple):
    """A node that publishes a topic; `sendings` is empty for one that was read from a file.

    `written` is the topic's name as the program or the file has it; `span` is None for what
    was read from a file.
    """

    node: GraphNode
    written: str
    type: InterfaceName | None
    sendings: tuple[Sending, ...]
    span: Span | None


class TopicSubscriber(NamedTuple):
    """A node that listens to a topic; `callback` is None where the target names it."""

    node: GraphNode
    written: str
    type: InterfaceName | None
    callback: str | None
    span: Span | None


class ServiceProvider(NamedTuple):
    """A node that provides a service; `handler` is None where the target names it."""

    node: GraphNode
    written: str
    type: InterfaceName | None
    handler: str | None
    span: Span | None


class ServiceClient(NamedTuple):
    """A node that calls a service, with the request of each call, in order."""

    node: GraphNode
    written: str
    type: InterfaceName | None
    requests: tuple[MessageValue, ...]
    span: Span | None


_End = TopicPublisher | TopicSubscriber | ServiceProvider | ServiceClient


class GraphTopic(NamedTuple):
    """A topic by its full name, with all who publish it and all who listen.

    `types` are the types in use, each once: one, unless files that were loaded disagree; none
    where no file says it.
    """

    name: str
    types: tuple[InterfaceName, ...]
    publishers: tuple[TopicPublisher, ...]
    subscribers: tuple[TopicSubscriber, ...]

    @property
    def type(self) -> InterfaceName | None:
        """The first type that is known."""
        return self.types[0] if self.types else None

    @property
    def missing(self) -> Missing | None:
        """The side that nobody takes, None when both are there."""
        if not self.publishers:
            return Missing.PUBLISHER
        return None if self.subscribers else Missing.SUBSCRIBER


class GraphService(NamedTuple):
    """A service by its full name, with all who provide it and all who call it."""

    name: str
    types: tuple[InterfaceName, ...]
    providers: tuple[ServiceProvider, ...]
    clients: tuple[ServiceClient, ...]

    @property
    def type(self) -> InterfaceName | None:
        """The first type that is known."""
        return self.types[0] if self.types else None

    @property
    def missing(self) -> Missing | None:
        """The side that nobody takes, None when both are there."""
        if not self.providers:
            return Missing.PROVIDER
        return None if self.clients else Missing.CLIENT


class Graph(NamedTuple):
    """The nodes, topics and services of a program, each in the order of the program."""

    nodes: tuple[GraphNode, ...]
    topics: tuple[GraphTopic, ...]
    services: tuple[GraphService, ...]


_Ends = dict[str, tuple[list[Any], list[Any]]]
"""By its full name, those that speak in a topic or service, and those that are spoken to."""


def graph_of(workspace: Workspace) -> Graph:
    """Return the graph of a workspace as it is at the end of the program."""
    topics: _Ends = {}
    services: _Ends = {}
    generated = {made.node.variable: made.library for made in workspace.generations}
    nodes = []
    for node in workspace.nodes.values():
        shown = _node(node, generated)
        nodes.append(shown)
        for publisher in node.of(Publisher).values():
            _ends(topics, node, publisher.name)[0].append(_publisher(shown, publisher))
        for listener in node.of(Subscription).values():
            _ends(topics, node, listener.name)[1].append(_subscriber(shown, listener))
        for service in node.of(Service).values():
            _ends(services, node, service.name)[0].append(_provider(shown, service))
        for client in node.of(Client).values():
            _ends(services, node, client.name)[1].append(_client(shown, client))
    return Graph(
        tuple(nodes),
        tuple([_topic(name, *map(tuple, ends)) for name, ends in topics.items()]),
        tuple([_service(name, *map(tuple, ends)) for name, ends in services.items()]),
    )


def _ends(all_: _Ends, node: Node, written: str) -> tuple[list[Any], list[Any]]:
    """Return the ends of a topic or service, by its name as a node has it."""
    name = resolved_name(node.name, written)
    ends = all_.get(name)
    if ends is None:
        ends = all_[name] = ([], [])
    return ends


def _node(node: Node, generated: dict[str, str]) -> GraphNode:
    return GraphNode(
        node.name,
        node.variable,
        node.library or generated.get(node.variable),
        node.source.path if node.source is not None else None,
        node.variable in generated,
        node.span,
    )


def _sending(publication: Publication) -> Sending:
    return Sending(publication.message.variable, publication.rate, publication.span)


def _publisher(node: GraphNode, publisher: Publisher) -> TopicPublisher:
    sendings = tuple([_sending(publication) for publication in publisher.publications])
    return TopicPublisher(node, publisher.name, publisher.type, sendings, publisher.span)


def _subscriber(node: GraphNode, listener: Subscription) -> TopicSubscriber:
    return TopicSubscriber(node, listener.name, listener.type, listener.callback, listener.span)


def _provider(node: GraphNode, service: Service) -> ServiceProvider:
    return ServiceProvider(node, service.name, service.type, service.callback, service.span)


def _client(node: GraphNode, client: Client) -> ServiceClient:
    return ServiceClient(node, client.name, client.type, client.requests, client.span)


def _topic(
    name: str, publishers: tuple[TopicPublisher, ...], subscribers: tuple[TopicSubscriber, ...]
) -> GraphTopic:
    return GraphTopic(name, _types(publishers, subscribers), publishers, subscribers)


def _service(
    name: str, providers: tuple[ServiceProvider, ...], clients: tuple[ServiceClient, ...]
) -> GraphService:
    return GraphService(name, _types(providers, clients), providers, clients)


def _types(*sides: tuple[_End, ...]) -> tuple[InterfaceName, ...]:
    types = {end.type: None for side in sides for end in side}
    types.pop(None, None)
    return tuple(types)  # type: ignore[arg-type]
