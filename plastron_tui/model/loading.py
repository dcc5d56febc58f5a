"""From what a reader found in a file to a node of the workspace."""

from __future__ import annotations

from collections.abc import Iterator

from plastron_tui.language.statements import Load

from .source import EndpointKind, SourceEndpoint, SourceFile
from .workspace import Client, Node, Publisher, Service, Subscription

_EDITABLE = frozenset(
    {
        EndpointKind.PUBLISHER,
        EndpointKind.SUBSCRIPTION,
        EndpointKind.SERVICE,
        EndpointKind.CLIENT,
    }
)


def loaded_node(source: SourceFile, statement: Load) -> Node:
    """Make a node of a file's endpoints; those whose name the file does not say stay unseen.

    A file may hold several nodes: they load as one, under the name of the first that has one.
    """
    name = next((node.name for node in source.nodes if node.name is not None), source.path.stem)
    loaded = Node(name, statement.variable, statement.span, source.library, source)
    for endpoint, topic in _named(source):
        match endpoint.kind:
            case EndpointKind.PUBLISHER:
                loaded.publishers.setdefault(topic, Publisher(topic, endpoint.type))
            case EndpointKind.SUBSCRIPTION:
                loaded.subscriptions.setdefault(
                    topic, Subscription(topic, endpoint.type, endpoint.callback)
                )
            case EndpointKind.SERVICE:
                loaded.services.setdefault(topic, Service(topic, endpoint.type, endpoint.callback))
            case EndpointKind.CLIENT:
                loaded.clients.setdefault(topic, Client(topic, endpoint.type))
            case _:
                pass
    return loaded


def _named(source: SourceFile) -> Iterator[tuple[SourceEndpoint, str]]:
    for node in source.nodes:
        for endpoint in node.endpoints:
            if endpoint.name is not None:
                yield endpoint, endpoint.name


def has_other_work(node: Node) -> bool:
    """Tell whether a loaded node does something that the workspace does not show."""
    if node.source is None:
        return False
    return any(
        endpoint.kind not in _EDITABLE or endpoint.name is None
        for source_node in node.source.nodes
        for endpoint in source_node.endpoints
    )
