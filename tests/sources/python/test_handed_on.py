"""Callbacks that get more than a message: another one in their place gets it as well."""

from __future__ import annotations

from pathlib import Path

import pytest
from updates import Outcome

ROSPY = """\
import functools
import rospy
from std_msgs.msg import String


def callback(data, driver):
    driver.send(data)


def hear(msg):
    print(msg)


def hear_all(msg, driver):
    print(msg, driver)


def aside(side, msg, driver, log=0):
    print(side, msg, driver, log)


def tell(driver, msg):
    print(msg, driver)


rospy.init_node('n')
{0}
rospy.spin()
"""
RCLPY = """\
import functools
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class N(Node):
    def __init__(self):
        super().__init__('n')
        {0}

    def callback(self, side, msg):
        print(side, msg)

    def hear(self, msg):
        print(msg)

    def hear_all(self, msg, info):
        print(msg, info)
"""
# The call and the function that it is to call; the call then, and the function where it is new.
ROSPY_CASES = {
    "a text": (
        "rospy.Subscriber('a', String, callback, 'x')", "on_a",
        "rospy.Subscriber('a', String, on_a, 'x')", "def on_a(data, driver):",
    ),
    "by keyword": (
        "rospy.Subscriber('a', String, callback=callback, callback_args=arm)", "on_a",
        "rospy.Subscriber('a', String, callback=on_a, callback_args=arm)",
        "def on_a(data, driver):",
    ),
    "a function of another file": (
        "rospy.Subscriber('a', String, callback=other.f, callback_args=arm)", "on_a",
        "rospy.Subscriber('a', String, callback=on_a, callback_args=arm)",
        "def on_a(message, args):",
    ),
    "none": (
        "rospy.Subscriber('a', String, callback, None, 5)", "on_a",
        "rospy.Subscriber('a', String, on_a, None, 5)", "def on_a(data):",
    ),
    "a function that takes it": (
        "rospy.Subscriber('a', String, callback, 'x')", "hear_all",
        "rospy.Subscriber('a', String, hear_all, 'x')", "",
    ),
    "a partial": (
        "rospy.Subscriber('a', String, functools.partial(aside, 'x', log=1), 'y')", "on_a",
        "rospy.Subscriber('a', String, functools.partial(on_a, 'x', log=1), 'y')",
        "def on_a(side, msg, driver, log):",
    ),
    "a partial, and a function that takes what it hands on": (
        "rospy.Subscriber('a', String, functools.partial(callback, 'x'))", "tell",
        "rospy.Subscriber('a', String, functools.partial(tell, 'x'))", "",
    ),
    "a partial, and a function that takes the message alone": (
        "rospy.Subscriber('a', String, functools.partial(callback, 'x'))", "hear",
        "rospy.Subscriber('a', String, hear)", "",
    ),
    "a lambda": (
        "rospy.Subscriber('a', String, lambda m: callback(m, 'x'))", "on_a",
        "rospy.Subscriber('a', String, on_a)", "def on_a(message):",
    ),
}  # fmt: skip
RCLPY_CASES = {
    "a partial": (
        "self.create_subscription(String, 'a', functools.partial(self.callback, 'x'), 10)", "on_a",
        "self.create_subscription(String, 'a', functools.partial(self.on_a, 'x'), 10)",
        "def on_a(self, side, msg):",
    ),
    "what else happens": (
        "self.create_subscription(String, 'a', self.hear, 10, event_callbacks=events)", "on_a",
        "self.create_subscription(String, 'a', self.on_a, 10, event_callbacks=events)",
        "def on_a(self, msg):",
    ),
    "what is known of a message": (
        "self.create_subscription(String, 'a', self.hear, 10)", "hear_all",
        "self.create_subscription(String, 'a', self.hear_all, 10)", "",
    ),
}  # fmt: skip
CASES = [("rospy", name) for name in ROSPY_CASES] + [("rclpy", name) for name in RCLPY_CASES]


def outcome(folder: Path, library: str, call: str, function: str) -> Outcome:
    text = {"rospy": ROSPY, "rclpy": RCLPY}[library].format(call)
    statements = "unsubscribe n from 'a'\nsubscribe n to 'a' of message_type String"
    return Outcome(folder, library, text, f"{statements} calling {function}")


@pytest.mark.parametrize(("library", "name"), CASES)
def test_another_callback_gets_the_same(tmp_path: Path, library: str, name: str) -> None:
    cases = {"rospy": ROSPY_CASES, "rclpy": RCLPY_CASES}[library]
    before, function, after, head = cases[name]
    found = outcome(tmp_path, library, before, function)
    assert after in [line.strip() for line in found.text.splitlines()]
    assert head in found.text
    assert (f"def {function}(" in found.text.replace(head or "\0", "")) is (head == "")


@pytest.mark.parametrize(
    ("call", "function", "message"),
    [
        ("callback, 'x'", "hear", "`hear` takes 1 argument, and would be called with 2"),
        ("hear", "callback", "`callback` takes 2 arguments, and would be called with 1"),
    ],
)
def test_a_function_that_does_not_take_it_is_refused(
    tmp_path: Path, call: str, function: str, message: str
) -> None:
    found = outcome(tmp_path, "rospy", f"rospy.Subscriber('a', String, {call})", function)
    assert [(str(each.code), each.message) for each in found.found] == [
        ("invalid-function", message)
    ]
    assert found.diff == []


def test_a_function_that_is_defined_later_is_there_when_the_call_is_made(tmp_path: Path) -> None:
    call = "rospy.Subscriber('a', String, hear)\n\n\ndef later(msg):\n    print(msg)\n\n"
    text = outcome(tmp_path, "rospy", call, "later").text
    assert text.index("def later") < text.index("String, later)") < text.index("rospy.spin()")


def test_it_is_told_that_a_lambda_goes(tmp_path: Path) -> None:
    call = "rospy.Subscriber('a', String, lambda m: seen.append(m))"
    (found,) = (each for each in outcome(tmp_path, "rospy", call, "on_a").found)
    assert found.code == "written-anew"
    assert found.message == "`lambda m: seen.append(m)` of `a` is not kept for `a`"
