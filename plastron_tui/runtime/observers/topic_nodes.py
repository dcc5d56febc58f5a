"""Which nodes are at a topic of ROS 2."""

from __future__ import annotations

from typing import Any


class TopicNodes:
    """Looks up who publishes and who listens, and remembers it: to ask for each topic takes time.

    A node that the middleware has only just heard of has no name yet, and one may take the place of
    another: what is remembered counts as long as there are the same nodes.
    """

    def __init__(self, node: Any) -> None:
        """Ask a node of rclpy."""
        self._node = node
        self._nodes: list[str] = []
        self._known: dict[str, tuple[tuple[int, int], list[str]]] = {}

    def see(self, nodes: list[str]) -> None:
        """Note which nodes there are now."""
        if nodes != self._nodes:
            self._nodes = nodes
            self._known.clear()

    def at(self, topic: str, ends: tuple[int, int]) -> list[str]:
        """Return the nodes at a topic that has so many publishers and subscriptions.

        Hidden nodes, as the monitor's own, and those whose names are not known yet are left out.
        """
        known = self._known.get(topic)
        if known is None or known[0] != ends:
            infos = [
                *self._node.get_publishers_info_by_topic(topic),
                *self._node.get_subscriptions_info_by_topic(topic),
            ]
            names = {
                f"{each.node_namespace.rstrip('/')}/{each.node_name}"
                for each in infos
                if not each.node_name.startswith("_")
            }
            known = self._known[topic] = ends, sorted(names)
        return known[1]
