"""What a node of somebody's sends once statements ask for more than it did."""

from __future__ import annotations

from pathlib import Path

import pytest
from graph import Graph
from processes import edit, own_tracebacks
from traffic import plain, record, send

pytestmark = [pytest.mark.live, pytest.mark.long]

NODES = {
    "ros2": """\
import rclpy
from std_msgs.msg import Int32


def hear(message):
    if message.data == 3:
        return
    print(message.data)


def main():
    rclpy.init()
    node = rclpy.create_node('relay')
    node.declare_parameter('rate', 20)
    node.declare_parameter('size', 100)
    node.create_subscription(Int32, 'numbers', hear, 10)
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass


main()
""",
    "ros1": """\
import rospy
from std_msgs.msg import Int32


def hear(message):
    if message.data == 3:
        return
    print(message.data)


def main():
    rospy.init_node('relay')
    rate = rospy.get_param('~rate', 20)
    size = rospy.get_param('~size', 100)
    print(rate, size)
    rospy.Subscriber('numbers', Int32, hear)
    rospy.spin()


main()
""",
}
STATEMENTS = """\
create_message byte of message_type std_msgs/Int8 and input data=received.data * 2
create_message size of message_type std_msgs/Int8 and input data=parameter 'size'
create_message beat of message_type std_msgs/Bool and input data=True
create_message map of message_type std_msgs/String and input data="map"
node publish byte to 'bytes' of message_type std_msgs/Int8 for_each 'numbers' when received.data > 0
node publish size to 'size' of message_type std_msgs/Int8 at 20 hz
node publish beat to 'beat' of message_type std_msgs/Bool at parameter 'rate' hz
node publish map to 'map' of message_type std_msgs/String once
"""
STEPS = [
    send("/numbers", {"data": 3}, "/bytes"),
    send("/numbers", {"data": 64}),
    send("/numbers", {"data": -5}),
    send("/numbers", {"data": 63}, "/bytes"),
]


def edited(graph: Graph, folder: Path) -> Path:
    """Make the changes in the node of a distribution."""
    original = folder / "relay.py"
    original.write_text(NODES["ros2" if graph.target == "rclpy" else "ros1"])
    (folder / "made").mkdir()
    return edit(original, STATEMENTS, folder / "made")


def test_a_message_follows_each_that_it_fits(graph: Graph, tmp_path: Path) -> None:
    """What no field can hold is not sent, and ends no node."""
    traffic = record(graph, edited(graph, tmp_path), STEPS, {})
    assert plain(dict(traffic.heard))["/bytes"] == [{"data": 6}, {"data": 126}]


def test_a_parameter_says_the_rate_and_a_value(graph: Graph, tmp_path: Path) -> None:
    node = graph.run_and_wait(edited(graph, tmp_path))
    heard = graph.listen({"/beat": "std_msgs/Bool", "/map": "std_msgs/String"}, 3)
    assert len(heard["/beat"]) >= 3
    assert [each.message["data"] for each in heard["/map"]] == ["map"]
    [size, *_] = graph.listen({"/size": "std_msgs/Int8"}, 1)["/size"]
    assert size.message == {"data": 100}
    graph.set_parameter("relay", "size", 1000)
    sizes = graph.listen({"/size": "std_msgs/Int8", "/beat": "std_msgs/Bool"}, 1, silent=["/size"])
    assert sizes["/size"] == []
    graph.set_parameter("relay", "size", -1)
    assert graph.listen({"/size": "std_msgs/Int8"}, 1)["/size"][-1].message == {"data": -1}
    assert node.interrupt() == 0
    assert not own_tracebacks(node.output)
