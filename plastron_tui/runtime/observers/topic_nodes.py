"""Which nodes are at a topic of ROS 2."""

from __future__ import annotations

from typing import Any

End = tuple[bool, str, str]
"""Whether a node sends, its name, and its quality of service in words."""


class TopicNodes:
    """Looks up who publishes and who listens, and remembers it: to ask for each topic takes time.

    A node that the middleware has only just heard of has no name yet, and one may take the place of
    another: what is remembered counts as long as there are the same nodes.
    """

    def __init__(self, node: Any) -> None:
        """Ask a node of rclpy."""
        self._node = node
        self._nodes: list[str] = []
        self._known: dict[str, tuple[tuple[int, int], list[End]]] = {}

    def see(self, nodes: list[str]) -> None:
        """Note which nodes there are now."""
        if nodes != self._nodes:
            self._nodes = nodes
            self._known.clear()

    def at(self, topic: str, ends: tuple[int, int]) -> list[str]:
        """Return the nodes at a topic that has so many publishers and subscriptions.

        Hidden nodes, as the monitor's own, and those whose names are not known yet are left out.
        """
        return sorted({node for _, node, _ in self.ends_at(topic, ends)})

    def ends_at(self, topic: str, ends: tuple[int, int]) -> list[End]:
        """Return the same nodes by what they do there, those that send first."""
        known = self._known.get(topic)
        if known is None or known[0] != ends:
            infos = (
                (True, self._node.get_publishers_info_by_topic(topic)),
                (False, self._node.get_subscriptions_info_by_topic(topic)),
            )
            found = {
                (sends, f"{each.node_namespace.rstrip('/')}/{each.node_name}", _words(each))
                for sends, side in infos
                for each in side
                if not each.node_name.startswith("_")
            }
            shown = sorted(found, key=lambda end: (not end[0], *end[1:]))
            known = self._known[topic] = ends, shown
        return known[1]


def _words(info: Any) -> str:
    """Return what matters when two ends are to match: the depth is not announced."""
    qos = info.qos_profile
    reliability = str(qos.reliability.name).lower().replace("_", " ")
    is_kept = qos.durability.name == "TRANSIENT_LOCAL"
    return f"{reliability}, transient local" if is_kept else reliability
