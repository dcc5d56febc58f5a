"""What is there of a running graph of ROS 2, as the studio's monitor tells it."""

from __future__ import annotations

from collections import Counter
from typing import Any

from goals_ros2 import STATUS, ActionClients, action_types
from monitor_subscriptions import Subscriptions
from topic_nodes import TopicNodes
from watch import is_shown

_INFRASTRUCTURE = ("rcl_interfaces/", "type_description_interfaces/", "lifecycle_msgs/")
_Ends = tuple[int, int]


class RunningGraph:
    """Looks for topics, services, actions and nodes; what the monitor itself has does not count.

    Attributes:
        publishers: how many publishers the monitor has, by topic.
    """

    def __init__(self, node: Any, topics: Subscriptions, clients: ActionClients) -> None:
        """Look with a node.

        Args:
            node: the monitor's.
            topics: those that the monitor listens to; it is told the types of all.
            clients: the monitor's own clients of actions.
        """
        self.publishers: Counter[str] = Counter()
        self._node = node
        self._topics = topics
        self._clients = clients
        self._topic_nodes = TopicNodes(node)
        self._providers: tuple[object, dict[str, list[str]]] = (None, {})

    def look(self) -> dict[str, Any]:
        """Return what is there now.

        Raises:
            Exception: of rclpy, whose kinds of error differ between distributions.
        """
        found = self._node.get_topic_names_and_types()
        nodes = [
            (name, namespace)
            for name, namespace in self._node.get_node_names_and_namespaces()
            if not name.startswith("_")
        ]
        names = sorted(map(_full_name, nodes))
        self._topic_nodes.see(names)
        return {
            "topics": self._found_topics(found),
            "services": self._found_services(nodes),
            "actions": self._found_actions(found),
            "nodes": names,
        }

    def _found_topics(self, found: list[tuple[str, list[str]]]) -> list[Any]:
        topics = []
        for name, types in found:
            if not is_shown(name):
                continue
            self._topics.types[name] = type_name = types[0].replace("/msg/", "/")
            ends = self._ends(name)
            publishers = ends[0] - self.publishers[name]
            subscribers = ends[1] - self._topics.hears(name)
            if publishers + subscribers > 0:
                at = self._topic_nodes.at(name, ends)
                who = self._topic_nodes.ends_at(name, ends)
                topics.append((name, type_name, publishers, subscribers, at, who))
        return topics

    def _found_services(self, nodes: list[tuple[str, str]]) -> list[Any]:
        services = [
            (name, types[0].replace("/srv/", "/"))
            for name, types in self._node.get_service_names_and_types()
            if is_shown(name) and not types[0].startswith(_INFRASTRUCTURE)
        ]
        # Each node is asked for its services, and so only where others are there than before.
        if services and self._providers[0] != (nodes, services):
            providers: dict[str, list[str]] = {}
            for node in nodes:
                for service in self._services_of(node):
                    providers.setdefault(service, []).append(_full_name(node))
            self._providers = (nodes, services), providers
        return [(name, type_, self._providers[1].get(name, [])) for name, type_ in services]

    def _services_of(self, node: tuple[str, str]) -> list[str]:
        try:
            found = self._node.get_service_names_and_types_by_node(*node)
        except RuntimeError:  # it has gone since it was listed
            return []
        return [name for name, _ in found]

    def _found_actions(self, found: list[tuple[str, list[str]]]) -> list[Any]:
        actions = []
        for name, type_ in action_types(found).items():
            if not is_shown(name):
                continue
            ends = self._ends(name + STATUS)
            if ends[0] + ends[1] - (name in self._clients) > 0:
                at = self._topic_nodes.at(name + STATUS, ends)
                actions.append((name, type_, ends[0], at))
        return actions

    def _ends(self, name: str) -> _Ends:
        return self._node.count_publishers(name), self._node.count_subscribers(name)


def _full_name(node: tuple[str, str]) -> str:
    return f"{node[1].rstrip('/')}/{node[0]}"
