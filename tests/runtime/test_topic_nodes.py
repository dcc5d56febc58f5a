"""Which nodes are said to be at a topic of ROS 2, while the middleware finds out who there is."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

import plastron_tui.runtime.observers as observers

UNKNOWN = ("_NODE_NAMESPACE_UNKNOWN_", "_NODE_NAME_UNKNOWN_")
MONITOR = ("/", "_plastron_monitor")
TALKER, LISTENER, OTHER = ("/", "talker"), ("/robot", "listener"), ("/", "other")


class Node:
    """A node that knows who publishes and who listens, and counts how often it is asked."""

    def __init__(self) -> None:
        self.publishing: list[tuple[str, str]] = []
        self.listening: list[tuple[str, str]] = []
        self.asked = 0

    def get_publishers_info_by_topic(self, name: str) -> list[Any]:
        self.asked += 1
        return [_info(*each) for each in self.publishing]

    def get_subscriptions_info_by_topic(self, name: str) -> list[Any]:
        return [_info(*each, "TRANSIENT_LOCAL") for each in self.listening]


def _info(namespace: str, name: str, durability: str = "VOLATILE") -> Any:
    named = SimpleNamespace
    qos = named(reliability=named(name="BEST_EFFORT"), durability=named(name=durability))
    return named(node_namespace=namespace, node_name=name, qos_profile=qos)


@pytest.mark.parametrize(
    ("steps", "told", "asked"),
    [
        # Nothing new, and nothing is asked again.
        ([([TALKER], [LISTENER])] * 2, [["/robot/listener", "/talker"]] * 2, 1),
        ([([TALKER], [MONITOR])], [["/talker"]], 1),
        # Its name comes later than what it publishes: the number is the same.
        ([([UNKNOWN], []), ([TALKER], [])], [[], ["/talker"]], 2),
        ([([TALKER], []), ([OTHER], [])], [["/talker"], ["/other"]], 2),
        ([([TALKER], []), ([TALKER], [OTHER])], [["/talker"], ["/other", "/talker"]], 2),
    ],
)
def test_the_nodes_at_a_topic_are_those_that_are_known_now(
    monkeypatch: pytest.MonkeyPatch, steps: list[Any], told: list[list[str]], asked: int
) -> None:
    monkeypatch.syspath_prepend(str(Path(observers.__file__).parent))
    from topic_nodes import TopicNodes

    node = Node()
    topic_nodes = TopicNodes(node)
    found = []
    for node.publishing, node.listening in steps:
        everyone = [*node.publishing, *node.listening]
        topic_nodes.see([name for _, name in everyone if not name.startswith("_")])
        found.append(topic_nodes.at("/a", (len(node.publishing), len(node.listening))))
    assert (found, node.asked) == (told, asked)


def test_the_number_tells_of_another_publisher_of_a_node_that_is_there(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.syspath_prepend(str(Path(observers.__file__).parent))
    from topic_nodes import TopicNodes

    node = Node()
    topic_nodes = TopicNodes(node)
    topic_nodes.see(["talker", "listener"])
    node.publishing = [TALKER]
    assert topic_nodes.at("/a", (1, 0)) == ["/talker"]
    node.listening = [LISTENER]
    assert topic_nodes.at("/a", (1, 1)) == ["/robot/listener", "/talker"]
    assert topic_nodes.ends_at("/a", (1, 1)) == [
        (True, "/talker", "best effort"),
        (False, "/robot/listener", "best effort, transient local"),
    ]
