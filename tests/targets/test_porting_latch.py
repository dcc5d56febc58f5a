"""What is latched in ROS 1 is kept for late subscriptions in ROS 2, and the other way round."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.session import Options, Session

NODE = """\
import rclpy
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from std_msgs.msg import String


class Robot(Node):
    def __init__(self):
        super().__init__("robot")
        self.pub = self.create_publisher(String, "a", {qos})


rclpy.init()
rclpy.spin(Robot())
"""
KEPT = "QoSProfile(depth={0}, durability=DurabilityPolicy.TRANSIENT_LOCAL{1})"


@pytest.mark.parametrize(
    ("qos", "written"),
    [
        (KEPT.format(1, ""), "queue_size=1, latch=True"),
        (KEPT.format(5, ""), "queue_size=5, latch=True"),
        (KEPT.format(1, ", reliability=ReliabilityPolicy.BEST_EFFORT"), None),
    ],
)
def test_kept_messages_are_latched(tmp_path: Path, qos: str, written: str | None) -> None:
    (tmp_path / "robot.py").write_text(NODE.replace("{qos}", qos))
    program = b"load 'robot.py' as n\ngenerate_node n using rospy\n"
    session = Session(program, tmp_path / "p.plastron", Options(), environ={})
    (made,) = session.generated()
    assert made.files is not None
    is_marked = any("quality of service" in each.message for each in made.diagnostics)
    assert is_marked == (written is None)
    text = made.files.files.main.decode()
    assert (f'rospy.Publisher("a", String, {written})' in text) == (written is not None)
