"""What statements add to nodes that a person wrote, for others and of them, on a real ROS.

What they talk to (`peer_rospy.py`, `peer_rclpy.py`) knows nothing of Plastron.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from graph import Graph, is_rate, rate_of
from machine import wait_until
from processes import Process, edit, own_tracebacks
from test_goals import (
    CANCELED,
    GOAL,
    REPLACED,
    check_goal_of_five_seconds,
    outcomes,
    peer,
    send,
    serve,
    times,
    told,
)

pytestmark = [pytest.mark.live, pytest.mark.long]

CHATTER = {
    "rclpy": """\
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import String


class Chatter(Node):
    def __init__(self):
        super().__init__('chatter')
        self.chatter_pub = self.create_publisher(String, 'chatter', 10)
        self.create_timer(0.1, self.tick)

    def tick(self):
        self.chatter_pub.publish(String(data='hello'))


if __name__ == '__main__':
    rclpy.init()
    try:
        rclpy.spin(Chatter())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
""",
    "rospy": """\
#!/usr/bin/env python3
import rospy
from std_msgs.msg import String


class Chatter:
    def __init__(self):
        self.chatter_pub = rospy.Publisher('chatter', String, queue_size=10)
        rospy.Timer(rospy.Duration(0.1), self.tick)

    def tick(self, event):
        self.chatter_pub.publish(String(data='hello'))


if __name__ == '__main__':
    rospy.init_node('chatter')
    Chatter()
    rospy.spin()
""",
}
"""A node for each library, which spins in one thread."""


def edited(graph: Graph, statement: str, folder: Path) -> Process:
    """Run a hand-written node that a statement changed."""
    (folder / "original").mkdir()
    original = folder / "original" / "chatter.py"
    original.write_text(CHATTER[graph.target])
    return graph.run(edit(original, f"node {statement}\n", folder))


def chats(graph: Graph) -> bool:
    """Tell whether the node does what it did before, meanwhile."""
    heard = graph.listen({"/chatter": "std_msgs/String"}, 2)["/chatter"]
    return is_rate(rate_of([each.time for each in heard]), 10)


def end(node: Process) -> None:
    node.interrupt()
    assert not own_tracebacks(node.output), node.output


def test_a_service_is_called_at_a_rate(graph: Graph, tmp_path: Path) -> None:
    node = edited(
        graph, "client_requests 'ready' of service_type Trigger with input none at 5 hz", tmp_path
    )
    node.wait_to_print("ready: ")
    server = peer(graph, "answer", 0.0)
    wait_until(lambda: len(told(server, "request", service="ready")) > 20, "many requests")
    assert is_rate(rate_of(times(told(server, "request", service="ready"))), 5)
    node.wait_to_print("success", count=3)
    assert chats(graph)
    end(node)
    server.interrupt()


SENDS = "sends_goal to 'count' of action_type Fibonacci with input order=5"


def test_a_goal_is_sent_once_its_server_is_there(service_graph: Graph, tmp_path: Path) -> None:
    node = edited(service_graph, SENDS, tmp_path)
    assert chats(service_graph)
    server = serve(service_graph, "succeed")
    node.wait_to_print("[3]")
    node.wait_to_print("[8]")
    assert chats(service_graph)
    assert [each["goal"] for each in told(server, "goal")] == [GOAL]
    end(node)
    server.interrupt()


def test_a_goal_that_is_rejected_is_an_error(service_graph: Graph, tmp_path: Path) -> None:
    node = edited(service_graph, SENDS, tmp_path)
    server = serve(service_graph, "reject")
    text = "the goal was rejected" if service_graph.target == "rclpy" else "count: REJECTED"
    node.wait_to_print(text)
    end(node)
    server.interrupt()


def test_an_action_is_provided(service_graph: Graph, tmp_path: Path) -> None:
    node = edited(service_graph, "provides_action 'count' of action_type Fibonacci", tmp_path)
    check_goal_of_five_seconds(service_graph, node)
    canceled = send(service_graph, cancel_at=3)
    assert outcomes(canceled) == {0: CANCELED[service_graph.target]}, node.output
    replaced = send(service_graph, second_at=3)
    expected = {0: REPLACED[service_graph.target], 1: "succeeded"}
    assert outcomes(replaced) == expected, node.output
    end(node)
