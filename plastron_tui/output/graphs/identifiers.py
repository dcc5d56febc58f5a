"""Short names for the things of a graph, by which a drawing joins them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from plastron_tui.model.graph import Graph, Hub
from plastron_tui.model.kinds import EndpointKind


class Edge(NamedTuple):
    """A node's part in a topic or service, as indices into the graph's tuples."""

    node: int
    kind: EndpointKind
    hub: int

    @property
    def node_id(self) -> str:
        """The node's identifier."""
        return f"n{self.node}"

    @property
    def hub_id(self) -> str:
        """The identifier of the topic or service."""
        return f"{(self.kind.facts.named or '')[:1]}{self.hub}"

    def hub_in(self, graph: Graph) -> Hub:
        """Return the topic or service."""
        assert self.kind.facts.interface is not None
        return graph.at[self.kind.facts.interface][self.hub]

    @property
    def ends(self) -> tuple[str, str]:
        """From whom to whom: messages and requests flow this way."""
        ends = (self.node_id, self.hub_id)
        return ends if self.kind.facts.sends else ends[::-1]


def identified(graph: Graph) -> Iterator[tuple[str, Hub]]:
    """Yield each topic and service with its identifier: `t0`, `s0`."""
    for hubs in graph.at.values():
        for number, hub in enumerate(hubs):
            yield f"{hub.noun[0]}{number}", hub


def edges_of(graph: Graph) -> Iterator[Edge]:
    """Yield each node's part in each topic and service once, also where it is written twice."""
    numbers = {node.variable: number for number, node in enumerate(graph.nodes)}
    seen: set[Edge] = set()
    for edge in _all_edges(graph, numbers):
        if edge not in seen:
            seen.add(edge)
            yield edge


def _all_edges(graph: Graph, numbers: dict[str, int]) -> Iterator[Edge]:
    for hubs in graph.at.values():
        for number, hub in enumerate(hubs):
            for end in (*hub.tails, *hub.heads):
                yield Edge(numbers[end.node.variable], end.kind, number)
