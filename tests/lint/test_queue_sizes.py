"""Which publishers of rospy are told for having no `queue_size`, and which setpoints no stamp."""

from __future__ import annotations

from pathlib import Path

import pytest
from linted import NO_QUEUE, run_over, told, write_tree

_LATE = """\
import rospy
from std_msgs.msg import String
def talk():
    {first}
    if rospy.is_shutdown():
        pub = rospy.Publisher('a', String)
        pub.publish('b')
"""
_SAID = """\
import rospy
from std_msgs.msg import String
pub = rospy.Publisher('a', String, {})
"""


@pytest.mark.parametrize(
    ("file", "text", "found"),
    [
        ("scripts/talker.py", NO_QUEUE, [("RC407", 3)]),
        ("scripts/talker.py", _SAID.format("queue_size=None"), [("RC407", 3)]),
        ("scripts/talker.py", _SAID.format("None, None, False, None, None, None"), [("RC407", 3)]),
        ("scripts/talker.py", _SAID.format("queue_size=size"), []),
        ("scripts/talker.py", _SAID.format("queue_size=0"), []),
        ("test/talker.py", NO_QUEUE, []),
        ("scripts/test_talker.py", NO_QUEUE, []),
        ("talker.py", _LATE.format(first="pass"), [("RC407", 6)]),
        ("talker.py", _LATE.format(first="return"), []),
        ("talker.py", _LATE.format(first="if rospy.is_shutdown(): return"), [("RC407", 6)]),
    ],
)
def test_publisher_that_is_made_needs_a_queue_size(
    tmp_path: Path, file: str, text: str, found: list[tuple[str, int]]
) -> None:
    assert told(run_over(write_tree(tmp_path, {file: text}), "RC407")) == found


_NODE = """\
from {module} import Node
from std_msgs.msg import String
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.{call}
    {more}
"""
_PUBLISHER = "create_publisher(String, 'a', queue_size=1)"


@pytest.mark.parametrize(
    ("call", "module", "more", "count"),
    [
        (_PUBLISHER, "rclpy.node", "pass", 1),
        ("create_subscription(String, 'a', print)", "rclpy.node", "pass", 1),
        ("create_publisher(String, 'a', qos_profile=1)", "rclpy.node", "pass", 0),
        ("create_publisher(String, 'a', 1)", "rclpy.node", "pass", 0),
        ("create_publisher(*NAMES)", "rclpy.node", "pass", 0),
        ("create_publisher(String, 'a', **QOS)", "rclpy.node", "pass", 0),
        ("create_service(String, 'a', print)", "rclpy.node", "pass", 0),
        (_PUBLISHER, "tools.node", "pass", 0),
        (_PUBLISHER, "rclpy.node", "def create_publisher(self, *a, **b): pass", 0),
        (f"inner.{_PUBLISHER}", "rclpy.node", "pass", 0),
    ],
)
def test_endpoint_of_rclpy_needs_a_profile(
    tmp_path: Path, call: str, module: str, more: str, count: int
) -> None:
    text = _NODE.format(call=call, module=module, more=more)
    found = told(run_over(write_tree(tmp_path, {"talker.py": text}), "RC407"))
    assert found == [("RC407", 6)] * count


@pytest.mark.parametrize(("topic", "count"), [("mavros/setpoint_position/local", 0), ("goal", 1)])
def test_nobody_reads_the_header_of_a_setpoint(tmp_path: Path, topic: str, count: int) -> None:
    text = f"""\
import rospy
from geometry_msgs.msg import PoseStamped
rospy.init_node('pilot')
pub = rospy.Publisher('{topic}', PoseStamped, queue_size=1)
pose = PoseStamped()
pose.pose.position.z = 2.0
pub.publish(pose)
rospy.spin()
"""
    root = write_tree(tmp_path, {"pilot.py": text})
    assert len(told(run_over(root, "RM205", "RM206"))) == count
