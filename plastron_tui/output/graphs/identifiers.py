"""Short names for the things of a graph, by which a drawing joins them."""

from __future__ import annotations

from collections.abc import Iterator
from enum import Enum
from typing import NamedTuple

from plastron_tui.model.graph import Graph


class Role(Enum):
    """What a node does at a topic or service."""

    PUBLISHES = "publishes"
    LISTENS = "listens"
    PROVIDES = "provides"
    CALLS = "calls"


class Edge(NamedTuple):
    """A node's part in a topic or service, as indices into the graph's tuples."""

    node: int
    role: Role
    place: int

    @property
    def node_id(self) -> str:
        """The node's identifier."""
        return f"n{self.node}"

    @property
    def place_id(self) -> str:
        """The identifier of the topic or service."""
        is_topic = self.role is Role.PUBLISHES or self.role is Role.LISTENS
        return f"{'t' if is_topic else 's'}{self.place}"

    @property
    def ends(self) -> tuple[str, str]:
        """From whom to whom: messages and requests flow this way."""
        if self.role is Role.PUBLISHES or self.role is Role.CALLS:
            return self.node_id, self.place_id
        return self.place_id, self.node_id


def edges_of(graph: Graph) -> Iterator[Edge]:
    """Yield each node's part in each topic and service once, also where it is written twice."""
    numbers = {node.variable: number for number, node in enumerate(graph.nodes)}
    seen: set[Edge] = set()
    for edge in _all_edges(graph, numbers):
        if edge not in seen:
            seen.add(edge)
            yield edge


def _all_edges(graph: Graph, numbers: dict[str, int]) -> Iterator[Edge]:
    for place, topic in enumerate(graph.topics):
        for publisher in topic.publishers:
            yield Edge(numbers[publisher.node.variable], Role.PUBLISHES, place)
        for listener in topic.subscribers:
            yield Edge(numbers[listener.node.variable], Role.LISTENS, place)
    for place, service in enumerate(graph.services):
        for client in service.clients:
            yield Edge(numbers[client.node.variable], Role.CALLS, place)
        for provider in service.providers:
            yield Edge(numbers[provider.node.variable], Role.PROVIDES, place)
