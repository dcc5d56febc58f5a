"""Bringing nodes from one ROS to the other, before → after."""

from __future__ import annotations

import pytest
from made_nodes import SPAN
from ported_nodes import (
    CATALOGS,
    LISTENER_1,
    LISTENER_2,
    MARK,
    OTHER,
    ported,
    source,
)

from plastron_tui.model.workspace import Node
from plastron_tui.targets import find_target

# A statement of a rospy node, and what becomes of it.
HEAD_1 = """\
import rospy
from std_msgs.msg import String
from std_srvs.srv import *

rospy.init_node('n')
"""
TO_RCLPY = [
    (
        "rospy.Subscriber('t', String)",
        "node.create_subscription(String, 't', lambda message: None, 10)",
    ),
    (
        "rospy.Subscriber('t', String, print, 'extra', queue_size=1)",
        "node.create_subscription(String, 't', lambda message: print(message, 'extra'), 1)",
    ),
    (
        "for x in y:\n    rospy.Subscriber('t', String, print, callback_args=x)",
        "for x in y:\n    node.create_subscription("
        "String, 't', lambda message, args=x: print(message, args), 10)",
    ),
    (
        "rospy.Subscriber('t', String, print, (1, 'extra'))",
        "node.create_subscription(String, 't', lambda message: print(message, (1, 'extra')), 10)",
    ),
    (
        "rospy.Service('s', Trigger, partial(answer, x))",
        "node.create_service(\n    Trigger, 's', "
        "lambda request, response, handler=partial(answer, x): handler(request)\n)",
    ),
    (
        "rospy.Timer(rospy.Duration(1), make(x))",
        f"{MARK}the event of the timer\n"
        "node.create_timer(1, lambda callback=make(x): callback(None))",
    ),
    (
        "rospy.Publisher('t', String, queue_size=None, latch=True)",
        "node.create_publisher(String, 't', "
        "QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL))",
    ),
    (
        "rospy.Publisher('t', String, queue_size=5, latch=keeps)",
        f"{MARK}latch\nnode.create_publisher(String, 't', 5)",
    ),
    (
        "NONE = 0\nrospy.Subscriber('t', String, print, queue_size=NONE, latch=False)",
        "NONE = 0\nnode.create_subscription(String, 't', print, 10)",
    ),
    (
        "rospy.Subscriber('t', String, print, buff_size=2**24)",
        "node.create_subscription(String, 't', print, 10)",
    ),
    (
        "rospy.ServiceProxy('s', Empty, True)",
        f"{MARK}the option True\nnode.create_client(Empty, 's')",
    ),
    ("rospy.ServiceProxy('s', Empty, False)", "node.create_client(Empty, 's')"),
    (
        "rospy.Timer(rospy.Duration(1), lambda e: print(e), True)",
        f"{MARK}oneshot; the event e\nnode.create_timer(1, lambda: (lambda e: print(e))(None))",
    ),
    (
        "def f(event):\n    use(event)\n\n\nrospy.Timer(rospy.Duration(1), f)",
        f"def f(event=None):\n    {MARK}the event event\n    use(event)\n\n\n"
        "node.create_timer(1, f)",
    ),
    (
        "p = rospy.ServiceProxy('s', Trigger, headers=h)",
        f"{MARK}headers\np = node.create_client(Trigger, 's')",
    ),
    (
        "class A:\n    def __init__(self):\n        self.seq = 0\n\n"
        "    def next(self):\n        return self.seq",
        "class A:\n    def __init__(self):\n        self.seq = 0\n\n"
        "    def next(self):\n        return self.seq",
    ),
    ("rospy.signal_shutdown('the end')", "rclpy.try_shutdown()"),
    ("start(rospy.signal_shutdown, 1)", "start(lambda reason: rclpy.try_shutdown(), 1)"),
    ("p = rospy.ServiceProxy('s', Trigger)", "p = node.create_client(Trigger, 's')"),
    (
        "rospy.Service('s', Trigger, lambda r: (True, ''))",
        "node.create_service(\n    Trigger,\n    's',\n    lambda request, response: "
        "(lambda r: Trigger.Response(success=True, message=''))(request),\n)",
    ),
    (
        "rospy.Timer(rospy.Duration(secs=2), lambda e: print(e))",
        "node.create_timer(2, lambda: (lambda e: print(e))(None))",
    ),
    (
        "m = rospy.wait_for_message('t', String, timeout=5)",
        "m = wait_for_message(node.create_subscription(String, 't', lambda message: None, 1), 5)",
    ),
    (
        "p = rospy.Publisher('~a', String, queue_size=1)",
        "p = node.create_publisher(String, '~/a', 1)",
    ),
    (
        "p = rospy.Publisher('~/a', String, queue_size=1)",
        "p = node.create_publisher(String, '/a', 1)",
    ),
    (
        "NAME = '~/a'\np = rospy.Publisher(NAME, String, queue_size=1)",
        f"NAME = '~/a'\n{MARK}a private name\np = node.create_publisher(String, NAME, 1)",
    ),
    ("if rospy.is_shutdown(): pass", "if not rclpy.ok(): pass"),
    ("go = not rospy.is_shutdown()", "go = rclpy.ok()"),
    (
        "p = rospy.Publisher('t', String, None, False, False, None, 5)",
        "p = node.create_publisher(String, 't', 5)",
    ),
    ("use(rospy.Rate(10))", "use(node.create_rate(10))"),
    ("x = rospy.get_param('~x', 1)", "x = get_param('x', 1)"),
    ('x = rospy.get_param("~a/b")', 'x = get_param("a.b")'),
    ("x = rospy.get_param('rate', [1, 2])", "x = get_param('rate', [1, 2])"),
    ("x = rospy.has_param('~x')", "x = has_param('x')"),
    ("rospy.set_param('~x', 1)", "set_param('x', 1)"),
    (
        "x = rospy.has_param('~x') and rospy.get_param('~x', 1)",
        f"{MARK}rospy.has_param\nx = rospy.has_param('~x') and get_param('x', 1)",
    ),
    *(
        (f"x = {call}", f"{MARK}{call.partition('(')[0]}\nx = {call}")
        for call in (
            "rospy.get_param('/x', 1)",
            "rospy.get_param('robot_description')",
            "rospy.get_param('~' + name)",
            "rospy.get_param('~x', {})",
            "rospy.get_param('~x', [1, 'a'])",
            "rospy.get_param(*args)",
            "rospy.set_param('x', 1)",
        )
    ),
    ("rospy.sleep(0.5)", "time.sleep(0.5)"),
    ("rospy.sleep(rospy.Duration(secs))", "time.sleep(secs)"),
    ("pause = 2\nrospy.sleep(pause)", "pause = 2\ntime.sleep(pause)"),
    ("rospy.sleep(pause)", f"{MARK}rospy.sleep\nrospy.sleep(pause)"),
    ("rospy.loginfo_throttle(2, 'a')", "node.get_logger().info('a', throttle_duration_sec=2)"),
    (
        "rospy.logwarn_throttle(1.0, 'a %d', x)",
        "node.get_logger().warning('a %d' % (x,), throttle_duration_sec=1.0)",
    ),
    (
        "rospy.logerr_throttle(\n    1,\n    x,\n)",
        "node.get_logger().error(\n    str(x), throttle_duration_sec=1,\n)",
    ),
    ("rospy.logdebug_once('a %s', x)", "node.get_logger().debug(f'a {x}', once=True)"),
    (
        "go(lambda: rospy.loginfo_once(x))",
        "go(lambda: node.get_logger().info(str(x), once=True))",
    ),
    ("t = rospy.Time.now().to_sec()", "t = node.get_clock().now().nanoseconds / 1e9"),
    (
        "a = rospy.Time.now()\nb = (rospy.Time.now() - a).to_sec() * 2",
        "a = node.get_clock().now()\nb = ((node.get_clock().now() - a).nanoseconds / 1e9) * 2",
    ),
    (
        "a = None\na = rospy.Time.now()\nif rospy.Time.now() - a > rospy.Duration(2): pass",
        "a = None\na = node.get_clock().now()\n"
        "if node.get_clock().now() - a > Duration(seconds=2): pass",
    ),
    (
        "a = rospy.Time.now()\nprint((rospy.Time.now() - a).to_sec(), a)",
        f"{MARK}rospy.Time.now\na = rospy.Time.now()\n"
        f"{MARK}.to_sec; rospy.Time.now\nprint((rospy.Time.now() - a).to_sec(), a)",
    ),
    (
        "p = rospy.ServiceProxy('s', Trigger)\nanswer = p()",
        "p = node.create_client(Trigger, 's')\nanswer = call_service(p, Trigger.Request())",
    ),
    (
        "p = rospy.ServiceProxy('s', Trigger)\n\n\ndef ask(client):\n    return client()",
        "p = node.create_client(Trigger, 's')\n\n\ndef ask(client):\n"
        f"    {MARK}the call of client\n    return client()",
    ),
]


@pytest.mark.parametrize(("before", "after"), TO_RCLPY)
def test_a_statement_of_rospy(before: str, after: str) -> None:
    text, _ = ported(HEAD_1 + before + "\n", "rospy")
    assert f"\n{after}\n" in text


@pytest.mark.parametrize("library", OTHER)
def test_a_node_that_plastron_wrote_leaves_nothing_to_port(library: str) -> None:
    target = find_target(library)
    assert target is not None
    rendered = target.render(Node("robot", "robot", SPAN), CATALOGS[library])
    assert rendered.files is not None
    text, found = ported(rendered.files.main.decode(), library)
    assert (list(found), MARK in text) == ([], False)


def test_one_spin_waits_as_long_in_ros_1() -> None:
    text, _ = ported(
        LISTENER_2.replace("rclpy.spin(node)", "rclpy.spin_once(node, timeout_sec=0.1)"), "rclpy"
    )
    assert "rospy.sleep(0.1)\n" in text


def test_windows_line_ends_stay() -> None:
    text, _ = ported(LISTENER_1.replace("\n", "\r\n"), "rospy")
    assert text == LISTENER_2.replace("\n", "\r\n")


def test_a_file_that_does_not_parse_is_refused() -> None:
    target = find_target("rclpy")
    assert target is not None
    read = source(LISTENER_1.replace("def listener():", "def listener(:"), "rospy")
    result = target.port(None, read, CATALOGS["rclpy"])  # type: ignore[arg-type]
    assert result.files is None
    assert [found.code for found in result.diagnostics] == ["edit-refused"]


PYTHON_2 = [
    ("raise X, y", "invalid syntax"),
    ("def f(a, (b, c)): pass", "parenthesized"),
    ("if x:\n            y()\n        z()", "unindent"),
]


@pytest.mark.parametrize(("line", "reason"), PYTHON_2)
def test_what_stays_of_python_2_is_refused_with_its_line(line: str, reason: str) -> None:
    target = find_target("rclpy")
    assert target is not None
    read = source(LISTENER_1.replace("text = shout", f"{line}\n    text = shout"), "rospy")
    result = target.port(None, read, CATALOGS["rclpy"])  # type: ignore[arg-type]
    assert result.files is None
    [found] = result.diagnostics
    assert reason in found.message and "(line" not in found.message
    assert found.help is not None and line.split("\n")[-1].strip() in found.help


def test_a_name_that_the_file_decides_is_listed() -> None:
    own = "x = ['~a']\nrospy.Publisher(rospy.resolve_name('x'), String)\n"
    text, found = ported(HEAD_1 + own, "rospy")
    assert "the name rospy.resolve_name('x')" in text
    assert any("the name rospy.resolve_name('x')" in each.message for each in found)


NAMES = ["a", "'x/' + a", "rospy.get_param('~topic')", "a.b", "'x/{}'.format(a)"]


@pytest.mark.parametrize("name", NAMES)
def test_a_name_that_is_the_same_in_both_is_not_listed(name: str) -> None:
    _, found = ported(f"{HEAD_1}p = rospy.Publisher({name}, String)\n", "rospy")
    assert [each.message for each in found] == []


def test_what_a_class_of_the_file_publishes_is_its_own_affair() -> None:
    own = "class A:\n    def publish(self, x): pass\n\n\na = A()\na.publish([1])\n"
    text, found = ported(f"{HEAD_1}p = rospy.Publisher('t', String)\n{own}", "rospy")
    assert text.endswith(own)
    assert [each.message for each in found] == []


def test_a_type_that_the_other_ros_lacks_is_marked() -> None:
    text, found = ported(
        "import rospy\nfrom rosgraph_msgs.msg import TopicStatistics\n\nrospy.init_node('n')\n"
        "rospy.Subscriber('s', TopicStatistics)\n",
        "rospy",
    )
    assert f"{MARK}rosgraph_msgs/TopicStatistics\nfrom rosgraph_msgs" in text
    assert found[0].help == "ROS 2 has statistics in `statistics_msgs`"


KEPT = "QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)"
LATCHED = [
    ("'map', OccupancyGrid", True),
    ("'/map', OccupancyGrid", True),
    ("'/robot_description', String", True),
    ("'map', String", False),
    ("'mapped', OccupancyGrid", False),
]


@pytest.mark.parametrize(("given", "is_kept"), LATCHED)
def test_what_is_latched_by_custom_is_heard_by_those_that_come_later(
    given: str, is_kept: bool
) -> None:
    head = f"{HEAD_1}from nav_msgs.msg import OccupancyGrid\n"
    text, _ = ported(f"{head}rospy.Subscriber({given}, print)\n", "rospy")
    assert (KEPT in text) == is_kept
    own = f"rospy.Publisher({given}, queue_size=1)\n"
    text, _ = ported(f"{head}{own}rospy.Subscriber({given}, print)\n", "rospy")
    assert KEPT not in text
