"""Parameters that only served what is removed are told of."""

from __future__ import annotations

from pathlib import Path

import pytest
from updates import Outcome

ROSPY = "import rospy\nfrom std_msgs.msg import Int32\np = rospy.Publisher('a', Int32)\n"
ROSPY += "def f():\n    {}\n    p.publish(Int32({}))\n\n\nf()\nrospy.Subscriber('b', Int32)\n"
RCLPY = """\
from rclpy.node import Node
from std_msgs.msg import Int32


class N(Node):
    def __init__(self):
        super().__init__('n')
        self.x = self.declare_parameter('x', 1).value
        self.create_subscription(Int32, 'b', print, 1)
        self.p = self.create_publisher(Int32, 'a', 1)
        self.p.publish(Int32(data=self.x))
"""
READ = "rospy.get_param('~x', 1)"
# The file and what of it is told.
CASES = {
    "one": ("rospy", ROSPY.format(f"x = {READ}", "x"), "`~/x`"),
    "in the message": ("rospy", ROSPY.format("pass", READ), "`~/x`"),
    "two": ("rospy", ROSPY.format(f"x, y = {READ}, rospy.get_param('y')", "x + y"), "`~/x`, `y`"),
    "one that is read elsewhere": ("rospy", ROSPY.format(f"print({READ})", READ), None),
    "none": ("rospy", ROSPY.format("pass", "1"), None),
    "one that is kept": ("rospy", ROSPY.format(f"x = {READ}; print(x)", "x"), None),
    "of rclpy": ("rclpy", RCLPY, None),
}


@pytest.mark.parametrize("name", CASES)
def test_parameters_that_nothing_reads_any_more(tmp_path: Path, name: str) -> None:
    library, text, said = CASES[name]
    outcome = Outcome(tmp_path, library, text, "n stop_publishing to 'a'")
    assert "ublisher(" not in outcome.text
    found = [each for each in outcome.found if each.code == "unread-parameter"]
    assert [each.message for each in found] == ([f"no longer read: {said}"] if said else [])
    assert all(each.span is not None for each in found)
