"""Times, durations and parameters, brought from one ROS to the other: before and after."""

from __future__ import annotations

import ast

import pytest
from ported_nodes import MARK, ported

ROSPY = """\
import rospy
from geometry_msgs.msg import PointStamped
from std_msgs.msg import Header


def hear(message):
    {inside}


rospy.init_node("n")
sub = rospy.Subscriber("point", PointStamped, hear)
"""
RCLPY = """\
import rclpy
from geometry_msgs.msg import PointStamped
from rclpy.duration import Duration


def hear(message):
    {inside}


rclpy.init()
node = rclpy.create_node("n")
sub = node.create_subscription(PointStamped, "point", hear, 10)
"""
NOW = "node.get_clock().now()"
CLOCK = "clock_type=node.get_clock().clock_type"
FROM_MESSAGE = "rclpy.time.Time.from_msg(message.header.stamp).nanoseconds"

MARKER = "from visualization_msgs.msg import Marker\nm = Marker()\n"
TO_RCLPY = [
    (
        f"{MARKER}m.lifetime = rospy.Duration(2)\nm.lifetime = rospy.Duration()",
        f"{MARKER}m.lifetime = Duration(seconds=2).to_msg()\nm.lifetime = Duration().to_msg()",
    ),
    (
        f"{MARKER}a = rospy.Duration.from_sec(2)\nx = Marker(lifetime=a)",
        f"{MARKER}a = Duration(seconds=2)\nx = Marker(lifetime=a.to_msg())",
    ),
    (
        f"{MARKER}x = Marker(scale=rospy.Duration(2))",
        f"{MARKER}{MARK}rospy.Duration\nx = Marker(scale=rospy.Duration(2))",
    ),
    (
        "end = rospy.Time.now() + rospy.Duration(5)\nwhile rospy.Time.now() < end: pass",
        f"end = {NOW} + Duration(seconds=5)\nwhile {NOW} < end: pass",
    ),
    (
        "a = rospy.Time(0)\nb = rospy.Time.now()\nc = b - a\nd = c.to_sec()",
        f"a = rclpy.time.Time(seconds=0, {CLOCK})\nb = {NOW}\nc = b - a\nd = c.nanoseconds / 1e9",
    ),
    (
        "limit = rospy.Duration(2)\na = rospy.Time.now()\nif rospy.Time.now() - a > limit: pass",
        f"limit = Duration(seconds=2)\na = {NOW}\nif {NOW} - a > limit: pass",
    ),
    (
        "a = rospy.Time.now()\nb = PointStamped()\nb.header.stamp = a",
        f"a = {NOW}\nb = PointStamped()\nb.header.stamp = a.to_msg()",
    ),
    (
        "a = rospy.Time.now()\nb = Header(stamp=a + rospy.Duration(1))",
        f"a = {NOW}\nb = Header(stamp=(a + Duration(seconds=1)).to_msg())",
    ),
    (
        "a = rospy.Time.now()\na = a + rospy.Duration(1)\nb = a.to_sec()",
        f"a = {NOW}\na = a + Duration(seconds=1)\nb = a.nanoseconds / 1e9",
    ),
    (
        "a = rospy.Time.now()\nuse(a)\nb = a - rospy.Duration(1)",
        f"{MARK}rospy.Time.now\na = rospy.Time.now()\nuse(a)\n"
        f"{MARK}rospy.Duration\nb = a - rospy.Duration(1)",
    ),
    (
        "a = rospy.Time(1, 2)",
        "a = rclpy.time.Time(seconds=1, nanoseconds=2, clock_type=node.get_clock().clock_type)",
    ),
    (
        "a = rospy.Time.from_sec(2)",
        "a = rclpy.time.Time(seconds=2, clock_type=node.get_clock().clock_type)",
    ),
    (
        "late = rospy.Time.now() - m.header.stamp > rospy.Duration(1, 2)",
        "late = node.get_clock().now() - rclpy.time.Time.from_msg(m.header.stamp) > Duration(\n"
        "    seconds=1, nanoseconds=2\n)",
    ),
    (
        "age = (rospy.Time.now() - m.header.stamp).to_sec()",
        "age = (node.get_clock().now() - rclpy.time.Time.from_msg(m.header.stamp))"
        ".nanoseconds / 1e9",
    ),
    (
        "if m.header.stamp < rospy.Time.now(): pass",
        "if rclpy.time.Time.from_msg(m.header.stamp) < node.get_clock().now(): pass",
    ),
    (
        "a = m.header.stamp\nb = rospy.Time.now() - a",
        f"a = m.header.stamp\n{MARK}rospy.Time.now\nb = rospy.Time.now() - a",
    ),
    (
        "b = use(rospy.Time.now() - m.header.stamp)",
        f"{MARK}rospy.Time.now\nb = use(rospy.Time.now() - m.header.stamp)",
    ),
    (
        "a = rospy.Time.now()\na = 5\nb = rospy.Time.now() - a",
        f"{MARK}rospy.Time.now\na = rospy.Time.now()\na = 5\n"
        f"{MARK}rospy.Time.now\nb = rospy.Time.now() - a",
    ),
]
INSIDE = [
    ("rospy", "a = message.header.stamp.secs", "a = message.header.stamp.sec"),
    ("rospy", "a = message.header.stamp.nsecs", "a = message.header.stamp.nanosec"),
    ("rospy", "a = message.header.stamp.to_sec()", f"a = {FROM_MESSAGE} / 1e9"),
    ("rospy", "a = 2 * message.header.stamp.to_sec()", f"a = 2 * ({FROM_MESSAGE} / 1e9)"),
    ("rospy", "a = message.header.stamp.to_nsec()", f"a = {FROM_MESSAGE}"),
    ("rospy", "a = watch.secs", f"{MARK}.secs\n    a = watch.secs"),
    ("rclpy", "a = message.header.stamp.sec", "a = message.header.stamp.secs"),
    ("rclpy", "a = message.header.stamp.nanosec", "a = message.header.stamp.nsecs"),
    ("rclpy", "a = watch.sec", f"{MARK}.sec\n    a = watch.sec"),
]
GET = "node.get_parameter"
BACK = [
    (f"a = {NOW}.nanoseconds / 1e9", "a = rospy.Time.now().to_nsec() / 1e9"),
    (
        f"a = {NOW}\nb = ({NOW} - a).nanoseconds",
        "a = rospy.Time.now()\nb = (rospy.Time.now() - a).to_nsec()",
    ),
    (
        f"a = {NOW}\nif {NOW} - a > Duration(seconds=2): pass",
        "a = rospy.Time.now()\nif rospy.Time.now() - a > rospy.Duration(2): pass",
    ),
    (
        f"a = {NOW}\nb = PointStamped()\nb.header.stamp = a.to_msg()",
        "a = rospy.Time.now()\nb = PointStamped()\nb.header.stamp = a",
    ),
    (
        f"a = {NOW}.to_msg()\nb = a.sec + a.nanosec\nc = PointStamped()\nc.header.stamp = a",
        "a = rospy.Time.now()\nb = a.secs + a.nsecs\nc = PointStamped()\nc.header.stamp = a",
    ),
    (f"a = {NOW}\nuse(a)", "a = rospy.Time.now()\nuse(a)"),
    (
        f"node.declare_parameter('a', 1.5)\nx = {GET}('a').value",
        "x = rospy.get_param('~a', 1.5)",
    ),
    (
        f"node.declare_parameter('a.b', 'c')\nx = {GET}('a.b').get_parameter_value().string_value",
        "x = rospy.get_param('~a/b', 'c')",
    ),
    (
        f'node.declare_parameter("a", "b")\nx = f"{{{GET}(\'a\').value}}"',
        "x = f\"{rospy.get_param('~a', 'b')}\"",
    ),
    (
        "x = f\"{node.declare_parameter('a', 1).value}\"",
        "x = f\"{rospy.get_param('~a', 1)}\"",
    ),
    ("rclpy.create_node('m').destroy_node()", f'{MARK}a second node\nrospy.init_node("m")'),
    ("x = node.declare_parameter('a', [1, -2]).value", "x = rospy.get_param('~a', [1, -2])"),
    (
        f"node.declare_parameters('', [('a', 1), ('b', True)])\n"
        f"x = node.create_rate({GET}('a').value)\ny = {GET}('b').value",
        "x = rospy.Rate(rospy.get_param('~a', 1))\ny = rospy.get_param('~b', True)",
    ),
    *(
        (
            f"{declared}\nx = {read}",
            f"{MARK}.{declared[5:].partition('(')[0]}\n{declared}\n"
            f"{MARK}.get_parameter\nx = {read}",
        )
        for declared, read in (
            ("node.declare_parameter('a', 1)", f"{GET}('a')"),
            ("node.declare_parameter('a', size())", f"{GET}('a').value"),
            ("node.declare_parameter('a')", f"{GET}('a').value"),
            ("node.declare_parameter('a', 1, ignore_override=True)", f"{GET}('a').value"),
            ("node.declare_parameter('a', 1)", f"{GET}(name).value + {GET}('a').type_"),
            ("node.declare_parameter('use_sim_time', False)", f"{GET}('use_sim_time').value"),
        )
    ),
]


def after_head(head: str, inside: str, behind: str, library: str) -> str:
    text = ported(head.replace("{inside}", inside) + behind + "\n", library)[0]
    ast.parse(text)
    return text


@pytest.mark.parametrize(("before", "after"), TO_RCLPY)
def test_times_of_rospy(before: str, after: str) -> None:
    assert after_head(ROSPY, "pass", before, "rospy").endswith(f"10)\n{after}\n")


@pytest.mark.parametrize(("library", "before", "after"), INSIDE)
def test_times_in_messages(library: str, before: str, after: str) -> None:
    head = ROSPY if library == "rospy" else RCLPY
    assert f"def hear(message):\n    {after}\n" in after_head(head, before, "", library)


@pytest.mark.parametrize(("before", "after"), BACK)
def test_times_and_parameters_of_rclpy(before: str, after: str) -> None:
    text = after_head(RCLPY, "pass", before, "rclpy")
    assert text.endswith(f"queue_size=10)\n{after}\n")


def test_a_parameter_that_is_set_stays() -> None:
    lines = (
        "node.declare_parameter('a', 1)\nnode.set_parameters([])\nx = f().get_parameter('a').value"
    )
    text = after_head(RCLPY, "pass", lines, "rclpy")
    assert "node.declare_parameter('a', 1)\n" in text
    assert "get_param(" not in text


def test_the_type_of_a_response_goes_with_it() -> None:
    head = RCLPY.replace("Duration\n", "Duration\nfrom std_srvs.srv import SetBool\n", 1)
    lines = (
        "def set(request: SetBool.Request, response: SetBool.Response):\n    return response\n\n\n"
        "node.create_service(SetBool, 'set', set)"
    )
    text = after_head(head, "pass", lines, "rclpy")
    assert (
        "def set(request: SetBoolRequest):\n    response = SetBoolResponse()\n    return response"
        in text
    )


def test_a_name_that_a_call_has_as_a_keyword_is_no_use_of_a_time() -> None:
    text, found = ported(
        "import rospy\nrospy.init_node('n')\nstart = rospy.Time.now()\n"
        "print((rospy.Time.now() - start).to_sec())\nplot(start=3)\n",
        "rospy",
    )
    assert MARK not in text, found
    assert "start = node.get_clock().now()\n" in text


def test_a_name_of_many_classes_is_looked_at_once() -> None:
    classes = "".join(
        f"class C{n}:\n    def __init__(self):\n        self.last = rospy.Time.now()\n\n"
        "    def age(self):\n        return rospy.Time.now() - self.last\n\n\n"
        for n in range(200)
    )
    text, _ = ported(f"import rospy\n\n\n{classes}rospy.init_node('n')\n", "rospy")
    assert text.count("class C") == 200
