"""What a node of rospy says and asks, brought to rclpy: before → after."""

from __future__ import annotations

import textwrap

import pytest
from ported_nodes import MARK, after_head, count_marks, ported

WORDS = [
    (
        "space = rospy.get_namespace()",
        "space = (node.get_namespace().rstrip('/') + '/')",
    ),
    ("rospy.loginfo('hello')", "node.get_logger().info('hello')"),
    ("rospy.loginfo('100%')", "node.get_logger().info('100%')"),
    ("rospy.loginfo('a %s', x)", "node.get_logger().info(f'a {x}')"),
    ("rospy.logwarn('%s is %s', x, y.z)", "node.get_logger().warning(f'{x} is {y.z}')"),
    ("rospy.logerr('a %d', x)", "node.get_logger().error('a %d' % (x,))"),
    ("rospy.logfatal('%s %s', f(x), y)", "node.get_logger().fatal('%s %s' % (f(x), y))"),
    ("rospy.logdebug('{} %s', x)", "node.get_logger().debug('{} %s' % (x,))"),
    ("rospy.loginfo('a' 'b %s', x)", "node.get_logger().info('a' 'b %s' % (x,))"),
    ("rospy.loginfo('5%% of %.2f', x)", "node.get_logger().info('5%% of %.2f' % (x,))"),
    ("rospy.loginfo('a %s' % x)", "node.get_logger().info('a %s' % x)"),
    ("rospy.loginfo('=' * 70)", "node.get_logger().info('=' * 70)"),
    ("rospy.loginfo(x)", "node.get_logger().info(str(x))"),
    (
        "rospy.loginfo('at %s', rospy.get_time())",
        "node.get_logger().info('at %s' % (node.get_clock().now().nanoseconds / 1e9,))",
    ),
    ("rospy.loginfo(rospy.get_name())", "node.get_logger().info(node.get_fully_qualified_name())"),
    ("name = rospy.get_name() + 'x'", "name = node.get_fully_qualified_name() + 'x'"),
    ("rospy.loginfo('a %s')", "node.get_logger().info('a %s')"),
    ("rospy.loginfo('a', x)", f"{MARK}rospy.loginfo\nrospy.loginfo('a', x)"),
    ("rospy.loginfo('%(a)s', x)", f"{MARK}rospy.loginfo\nrospy.loginfo('%(a)s', x)"),
    ("rospy.loginfo('%*d', 1, x)", f"{MARK}rospy.loginfo\nrospy.loginfo('%*d', 1, x)"),
    ("rospy.loginfo(x, y)", f"{MARK}rospy.loginfo\nrospy.loginfo(x, y)"),
    ("rospy.loginfo(*x)", f"{MARK}rospy.loginfo\nrospy.loginfo(*x)"),
    (
        "rospy.loginfo('a', exc_info=True)",
        f"{MARK}rospy.loginfo\nrospy.loginfo('a', exc_info=True)",
    ),
    ("x = rospy.is_shutdown() or y", "x = not rclpy.ok() or y"),
    ("x = not rospy.is_shutdown() and y", "x = rclpy.ok() and y"),
    ("x.header.stamp = rospy.Time.now()", "x.header.stamp = node.get_clock().now().to_msg()"),
    (
        "x = Header()\nx.stamp = rospy.Time.now()",
        "x = Header()\nx.stamp = node.get_clock().now().to_msg()",
    ),
    (
        "myheader.stamp = rospy.Time.now()",
        f"{MARK}rospy.Time.now\nmyheader.stamp = rospy.Time.now()",
    ),
    ("x = Header(stamp=rospy.Time.now())", "x = Header(stamp=node.get_clock().now().to_msg())"),
    ("x = rospy.Time.now()", "x = node.get_clock().now()"),
    ("f(rospy.Time.now())", f"{MARK}rospy.Time.now\nf(rospy.Time.now())"),
    (
        "text.publish('it is %s' % rospy.get_time())",
        "text.publish(String(data='it is %s' % (node.get_clock().now().nanoseconds / 1e9)))",
    ),
]


@pytest.mark.parametrize(("before", "after"), WORDS)
def test_what_a_node_says_and_asks(before: str, after: str) -> None:
    text = after_head(before)
    assert text.endswith(f"\n{after}\n")
    assert count_marks(text) == after.count(MARK)


@pytest.mark.parametrize(("before", "after"), WORDS)
def test_a_callback_says_the_same(before: str, after: str) -> None:
    body = textwrap.indent(before, "    ")
    text = after_head(f"def hear(msg):\n{body}\n\n\nrospy.Subscriber('s', String, hear)")
    assert f"def hear(msg):\n{textwrap.indent(after, '    ')}\n" in text


def test_what_stands_before_the_node_is_made_is_marked() -> None:
    text, _ = ported("import rospy\n\n\ndef main(name):\n    rospy.loginfo('a')\n"
                     "    rospy.init_node(name)\n    rospy.loginfo('b')\n", "rospy")  # fmt: skip
    assert f"    {MARK}rospy.loginfo\n    rospy.loginfo('a')\n" in text
    assert "    node.get_logger().info('b')\n" in text
