"""Times, durations and helpers of rclpy, brought to rospy wherever they stand: before → after."""

from __future__ import annotations

import ast

import pytest
from ported_nodes import MARK, count_marks, ported

HEAD = """\
import rclpy
import rclpy.time
import tf2_ros
from builtin_interfaces.msg import Duration as Lasting
from rclpy.duration import Duration
from rclpy.time import Time
from rclpy.utilities import remove_ros_args
from tf2_ros import TransformListener

rclpy.init()
node = rclpy.create_node("n")
"""
NOW = "node.get_clock().now()"
VALUES = [
    (f"use({NOW})", "use(rospy.Time.now())"),
    (f"use({NOW}.to_msg())", "use(rospy.Time.now())"),
    (f"use({NOW}.nanoseconds)", "use(rospy.Time.now().to_nsec())"),
    ("use(rclpy.time.Time())", "use(rospy.Time())"),
    ("use(Time(seconds=3))", "use(rospy.Time(3))"),
    ("use(Time(nanoseconds=x))", "use(rospy.Time(0, x))"),
    ("use(Time(seconds=3, nanoseconds=x))", "use(rospy.Time(3, x))"),
    (
        "use(Time(seconds=0.5, nanoseconds=x))",
        f"{MARK}rclpy.time.Time\nuse(Time(seconds=0.5, nanoseconds=x))",
    ),
    ("use(rclpy.time.Duration(seconds=x))", "use(rospy.Duration(x))"),
    ("use(Duration(seconds=x).to_msg())", "use(rospy.Duration(x))"),
    ("use(Lasting(sec=1, nanosec=2))", "use(rospy.Duration(1, 2))"),
    ("x: Time = Time()", "x: rospy.Time = rospy.Time()"),
    ("def f(x: Lasting): pass", "def f(x: rospy.Duration): pass"),
    ("use(Lasting())", "use(rospy.Duration())"),
    ("use(Time.from_msg(m.header.stamp))", "use(m.header.stamp)"),
    ("use(Time.from_msg(m.stamp).nanoseconds)", "use(m.stamp.to_nsec())"),
    ("use(a.to_msg())", f"{MARK}.to_msg\nuse(a.to_msg())"),
    ("use(remove_ros_args(args=a))", "use(rospy.myargv(argv=a))"),
    ("tf2_ros.Buffer()", "tf2_ros.Buffer()"),
    ("TransformListener(b, node)", "TransformListener(b)"),
    ("TransformListener(b, node, spin_thread=True)", "TransformListener(b)"),
    ("tf2_ros.TransformBroadcaster(node=node)", "tf2_ros.TransformBroadcaster()"),
    (
        "tf2_ros.TransformBroadcaster(node, qos=q)",
        f"{MARK}tf2_ros.TransformBroadcaster\ntf2_ros.TransformBroadcaster(node, qos=q)",
    ),
]


@pytest.mark.parametrize(("before", "after"), VALUES)
def test_values_of_rclpy(before: str, after: str) -> None:
    text, _ = ported(f"{HEAD}{before}\n", "rclpy")
    ast.parse(text)
    assert text.endswith(f'rospy.init_node("n")\n{after}\n')
    assert count_marks(text) == after.count(MARK)
    assert ("Lasting" in text) == ("Lasting" not in before)


NONE = ", which is None\n"
NODES = [
    ("n = rclpy.create_node('n')\nrclpy.spin(n)", "rospy.init_node('n')\nrospy.spin()"),
    (
        "n = rclpy.create_node('n')\nn.create_publisher(n.kind, 'x', 1)",
        f"n = rospy.init_node('n')\n{MARK}n{NONE}rospy.Publisher('x', n.kind, queue_size=1)",
    ),
    (
        "n = rclpy.create_node('n')\nhelp(n)\nx.n(n=1)",
        f"n = rospy.init_node('n')\n{MARK}n{NONE}help(n)\nx.n(n=1)",
    ),
    (
        "n = rclpy.create_node('n')\nn.get_name()",
        f"n = rospy.init_node('n')\n{MARK}.get_name\nn.get_name()",
    ),
    (
        "class A:\n    def f(self):\n        self.n = rclpy.create_node('n')\n"
        "        help(self.n)\n\n\nclass B:\n    def f(self):\n        help(self.n)",
        "class A:\n    def f(self):\n        self.n = rospy.init_node('n')\n"
        f"        {MARK}self.n{NONE}        help(self.n)\n\n\n"
        "class B:\n    def f(self):\n        help(self.n)",
    ),
]


@pytest.mark.parametrize(("before", "after"), NODES)
def test_what_holds_a_node(before: str, after: str) -> None:
    text, _ = ported(f"import rclpy\nrclpy.init()\n{before}\n", "rclpy")
    assert text == f"import rospy\n{after}\n"


CLASS = """\
import rclpy
from std_srvs.srv import Trigger


class Robot:
    def __init__(self, host):
        self.host = host

    def use(self):
        {inside}


class A(rclpy.node.Node):
    def __init__(self):
        super().__init__("a")
        self.client = self.create_client(Trigger, "s")
        {line}
"""
WAIT = f"{MARK}wait_for_service returns None, and raises on a timeout"
METHODS = [
    ("pass", "self.robot = Robot(self)", ""),
    ("self.host.create_client(*a)", "self.robot = Robot(self)", f"{MARK}Robot(self)"),
    ("self.host.declare_parameter('a', f())", "x = Robot(self)", f"{MARK}Robot(self)"),
    ("self.host.declare_parameter('a', f())", "x = Robot(1)", ""),
    ("pass", "while not self.client.wait_for_service(timeout_sec=1.0): pass", WAIT),
    ("pass", "self.client.wait_for_service(1.0)", WAIT),
    ("pass", "self.client.wait_for_service()", ""),
]


@pytest.mark.parametrize(("inside", "line", "mark"), METHODS)
def test_what_a_node_is_asked(inside: str, line: str, mark: str) -> None:
    text, _ = ported(CLASS.format(inside=inside, line=line), "rclpy")
    ast.parse(text)
    above = f"        {mark}\n" if mark else ""
    assert text.endswith(f'ServiceProxy("s", Trigger)\n{above}        {line}\n')
    assert (MARK in text.partition("class A")[0]) == (inside != "pass")
