"""Endpoints of lifecycle nodes: what a transition creates, the one that undoes it destroys."""

from __future__ import annotations

import pytest
from edits import AT, edited, provide, publish, request, subscribe

from plastron_tui.model.kinds import kind_of
from plastron_tui.model.source import Remove

HEAD = (
    "import rclpy\nfrom rclpy.lifecycle import LifecycleNode\nfrom std_msgs.msg import String\n\n\n"
    "class Cell(LifecycleNode):\n"
)
CONFIGURE = (
    "    def on_configure(self, state):\n"
    "        self.a_pub = self.create_publisher(String, 'a', 10)\n"
    "        self.b_sub = self.create_subscription(String, 'b', print, 10)\n"
    "        return super().on_configure(state)\n"
)
TAIL = "\n\nrclpy.init()\nrclpy.spin(Cell('cell'))\n"
DESTROYS = (
    "\n    def on_cleanup(self, state):\n        self.destroy_subscription(self.b_sub)\n"
    "        self.destroy_publisher(self.a_pub)\n        return super().on_cleanup(state)\n"
)
FORGETS = (
    "\n    def on_cleanup(self, state):\n        self.b_sub = None\n"
    "        return super().on_cleanup(state)\n"
)
HELPS = (
    "\n    def on_cleanup(self, state):\n        self.close()\n"
    "        return super().on_cleanup(state)\n\n"
    "    def close(self):\n        if self.a_pub is not None:\n"
    "            self.destroy_publisher(self.a_pub)\n"
)
BRANCHES = (
    "\n    def on_cleanup(self, state):\n        if self.a_pub is None:\n"
    "            return super().on_cleanup(state)\n        else:\n"
    "            return super().on_cleanup(state)\n"
)
STOPS = (
    "\n    def start(self):\n        print(self.a_pub)\n"
    "        self.other = self.create_publisher(String, 'c', 10)\n"
    "\n    def stop(self):\n        self.destroy_publisher(self.other)\n"
    "\n\nclass Other:\n    def close(self):\n        self.destroy_publisher(self.a_pub)\n"
)
NODES = {
    "one that returns in branches": HEAD + CONFIGURE + BRANCHES + TAIL,
    "one that destroys": HEAD + CONFIGURE + DESTROYS + TAIL,
    "one that forgets": HEAD + CONFIGURE + FORGETS + TAIL,
    "one with a helper": HEAD + CONFIGURE + HELPS + TAIL,
    "one that destroys others elsewhere": HEAD + CONFIGURE + FORGETS + STOPS + TAIL,
    "one without": HEAD + CONFIGURE + TAIL,
}
CHANGES = {
    "a publisher": (publish("x"), ["self.destroy_publisher(self.x_pub)"]),
    "messages": (
        publish("x", rate=2.0, data="hi"),
        ["self.destroy_publisher(self.x_pub)", "self.destroy_timer(self.x_timer)"],
    ),
    "a subscription": (subscribe("x"), ["self.destroy_subscription(self.x_sub)"]),
    "a service": (provide("x"), ["self.destroy_service(self.x_srv)"]),
    "a call": (
        request("x", "std_srvs/Trigger"),
        ["self.destroy_client(self.x_client)", "self.destroy_timer(self.x_timer)"],
    ),
}


@pytest.mark.parametrize("node", NODES)
@pytest.mark.parametrize("change", CHANGES)
def test_what_a_transition_creates_is_destroyed(node: str, change: str) -> None:
    changed, destroying = CHANGES[change]
    after = edited(NODES[node], changed)
    undone = after.partition("def close(" if node == "one with a helper" else "def on_cleanup(")[2]
    end = "destroy_publisher(self.a_pub)" if node == "one with a helper" else "return super().on_c"
    for line in destroying:
        assert after.count(line) == 1
        assert (undone.index(line) < undone.index(end)) is (node != "one with a helper")
        assert undone.partition("\n    def ")[0].count(f"        {line}\n") == 1
        holder = line.partition("(")[2].rstrip(")")
        assert f"        {holder} = self.create_" in after


@pytest.mark.parametrize(
    ("node", "method"),
    [
        ("one that destroys", "destroy_publisher"),
        ("one that forgets", "destroy_lifecycle_publisher"),
        ("one without", "destroy_lifecycle_publisher"),
    ],
)
def test_a_publisher_is_one_of_the_lifecycle_as_the_others_are(node: str, method: str) -> None:
    text = NODES[node].replace("create_publisher", "create_lifecycle_publisher")
    after = edited(text, publish("x"))
    assert "self.x_pub = self.create_lifecycle_publisher(String, 'x', 10)" in after
    assert f"self.{method}(self.x_pub)" in after


def test_what_is_activated_is_destroyed_too() -> None:
    text = NODES["one that forgets"].replace("configure", "activate")
    after = edited(text.replace("cleanup", "deactivate"), subscribe("x"))
    line = "        self.destroy_subscription(self.x_sub)\n"
    assert f"{line}        return super().on_deactivate(state)\n" in after


def test_a_method_of_another_node_is_no_transition() -> None:
    text = NODES["one that destroys"].replace("LifecycleNode", "Node").replace("lifecycle", "node")
    assert "(self.x_sub)" not in edited(text, subscribe("x"))


def test_what_the_constructor_creates_stays() -> None:
    made = "    def __init__(self):\n        super().__init__('cell')\n\n"
    text = HEAD + made + CONFIGURE.replace("configure", "ready") + TAIL
    assert "destroy_" not in edited(text, publish("x", rate=2.0, data="hi"))


@pytest.mark.parametrize("node", [each for each in NODES if each != "one without"])
@pytest.mark.parametrize("change", CHANGES)
def test_what_was_added_goes_again(node: str, change: str) -> None:
    changed, _ = CHANGES[change]
    remove = Remove(kind_of(type(changed.endpoint)), "x", AT)
    assert edited(edited(NODES[node], changed), remove) == NODES[node]
