"""What a node of rospy waits for, and what is called as it ends, brought to rclpy."""

from __future__ import annotations

import ast

import pytest
from ported_nodes import MARK, count_marks, ported

HEAD = """\
import sys

import rospy
from std_msgs.msg import String
from std_srvs.srv import Empty, Trigger


def stop():
    pass


rospy.init_node("n")
ask = rospy.ServiceProxy("ask", Trigger)
text = rospy.Publisher("text", String, queue_size=1)
hear = rospy.Subscriber("text", String, print)
answer = rospy.Service("answer", Empty, stop)
"""
MESSAGE = "node.create_subscription(String, 't', lambda message: None, 1)"
INTERRUPTS = "KeyboardInterrupt, ExternalShutdownException, ROSInterruptException"


def after_head(text: str, head: str = HEAD) -> str:
    """Bring some lines to rclpy, behind a node and its endpoints; the result is Python."""
    result = ported(head + text + "\n", "rospy")[0]
    ast.parse(result)
    return result


LINES = [
    ("rospy.wait_for_service('ask')", "wait_for_service('ask')"),
    ("rospy.wait_for_service('ask', timeout=2.5)", "wait_for_service('ask', timeout=2.5)"),
    ("rospy.wait_for_service('ask', 5)", "wait_for_service('ask', 5)"),
    ("ask.wait_for_service()", "wait_for_service(ask.srv_name)"),
    ("ask.wait_for_service(timeout=3)", "wait_for_service(ask.srv_name, timeout=3)"),
    ("text.unregister()", "node.destroy_publisher(text)"),
    ("hear.unregister()", "node.destroy_subscription(hear)"),
    ("answer.shutdown()", "node.destroy_service(answer)"),
    ("if text.get_num_connections(): pass", "if text.get_subscription_count(): pass"),
    ("x = hear.get_num_connections()", "x = hear.get_publisher_count()"),
    ("rospy.on_shutdown(stop)", "shutdown_hooks.append(stop)"),
    ("args = rospy.myargv()", "args = remove_ros_args()"),
    ("args = rospy.myargv(argv=sys.argv)[1:]", "args = remove_ros_args(args=sys.argv)[1:]"),
    *(
        (line, f"{MARK}{what}\n{line}")
        for line, what in (
            ("rospy.wait_for_service('~ask')", "rospy.wait_for_service"),
            ("rospy.wait_for_service(name)", "rospy.wait_for_service"),
            ("rospy.wait_for_service('ask', limit)", "rospy.wait_for_service"),
            ("ask.wait_for_service(limit)", ".wait_for_service"),
            ("pool.unregister()", ".unregister"),
            ("x = text.unregister()", ".unregister"),
            ("rospy.on_shutdown(h=stop)", "rospy.on_shutdown"),
        )
    ),
]


@pytest.mark.parametrize(("before", "after"), LINES)
def test_a_line(before: str, after: str) -> None:
    text = after_head(before)
    assert text.endswith(f"\n{after}\n")
    assert count_marks(text) == after.count(MARK)


def test_what_waits_in_a_callback_has_a_thread_and_a_group_of_its_own() -> None:
    text = after_head("def tick(event):\n    ask()\n\n\nrospy.Timer(rospy.Duration(1), tick)")
    assert "executor = MultiThreadedExecutor(num_threads=2)\n" in text
    group = "callback_group=ReentrantCallbackGroup()"
    assert f'ask = node.create_client(Trigger, "ask", {group})' in text
    assert "def tick(event=None):\n    call_service(ask, Trigger.Request())\n" in text


def test_a_node_without_callbacks_waits_for_what_one_thread_handles() -> None:
    head = HEAD.partition("hear =")[0]
    text = after_head("ask()\nm = rospy.wait_for_message('t', String, 5)", head)
    assert "MultiThreadedExecutor" not in text
    assert "callback_group" not in text
    assert text.endswith(
        f"call_service(ask, Trigger.Request())\nm = wait_for_message({MESSAGE}, 5)\n"
    )


def test_a_service_of_the_file_itself_is_not_waited_for() -> None:
    line = "own = rospy.ServiceProxy('answer', Empty)\nown()"
    assert after_head(line).endswith(f"{MARK}the call of own\nown()\n")


CAUGHT = [
    ("ask()", "rospy.ServiceException as e", "ServiceException as e"),
    ("ask()", "rospy.ROSException", f"(ROSException, {INTERRUPTS})"),
    ("wait()", "rospy.ROSException", f"(ROSException, {INTERRUPTS})"),
    ("wait()", "(rospy.ServiceException, OSError) as e", "(ServiceException, OSError) as e"),
    ("rospy.sleep(1)", "rospy.ServiceException", None),
    ("other()", "rospy.ROSException", None),
]


@pytest.mark.parametrize(("body", "before", "after"), CAUGHT)
def test_what_is_caught_where_something_waits(body: str, before: str, after: str | None) -> None:
    waits = "def wait():\n    rospy.wait_for_service('ask')\n\n\n"
    text = after_head(f"{waits}try:\n    {body}\nexcept {before}:\n    pass")
    assert f"except {after or before}:\n" in text
    assert (MARK in text) == (after is None)
    if after is not None:
        assert f"class {after.strip('(').split(',')[0].split(' ')[0]}(Exception):" in text


def test_hooks_are_called_before_ros_ends() -> None:
    text = after_head("rospy.on_shutdown(stop)\nrospy.signal_shutdown('done')\nrospy.spin()")
    assert text.endswith("shutdown_hooks.append(stop)\nshut_down()\nwait()\n")
    assert "rclpy.init(signal_handler_options=SignalHandlerOptions.NO)\n" in text
    assert "signal.SIGINT, lambda number, frame: shut_down()" in text
    assert "atexit.register(shut_down)" in text


def test_a_file_without_a_node_leaves_what_waits() -> None:
    head = HEAD.replace('rospy.init_node("n")\n', "")
    text = after_head("rospy.on_shutdown(stop)\nrospy.wait_for_service('ask')\nask()", head)
    for what in ("rospy.on_shutdown", "rospy.wait_for_service", "the call of ask"):
        assert f"{MARK}{what}\n" in text


@pytest.mark.parametrize("line", ["hear.unregister()", "rospy.wait_for_message('t', String)"])
def test_what_is_destroyed_while_others_go_on_is_no_error(line: str) -> None:
    assert "        except InvalidHandle:\n" in after_head(line)
    assert "InvalidHandle" not in after_head("rospy.wait_for_service('ask')")


def test_the_level_of_the_log_is_set() -> None:
    text = after_head("rospy.init_node('m', log_level=rospy.DEBUG)", "import rospy\n")
    assert text.endswith("\nnode.get_logger().set_level(LoggingSeverity.DEBUG)\n")
    assert MARK not in text
