"""Types of packages that are not installed, as far as the program is told what is."""

from __future__ import annotations

import pytest
from workspaces import FakeReader, catalog, marked

from plastron_tui.diagnostics import Diagnostic, Severity, codes
from plastron_tui.language import Document, lower
from plastron_tui.model.context import Setting
from plastron_tui.model.interpreter import interpret
from plastron_tui.targets import LIBRARIES

NODE = "create_node 'a' as a\n"


def absent(ros_version: int, package: str) -> Diagnostic | None:
    if package not in ("nav_msgs", "tf2_msgs"):
        return None
    return Diagnostic(codes.MISSING_ROS_PACKAGE, f"no {package} in ROS {ros_version}")


def told(text: str, library: str = "rclpy") -> list[tuple[str, str]]:
    setting = Setting(library, LIBRARIES, catalog, FakeReader(), absent=absent)
    found = interpret(lower(Document(text.encode())), setting).diagnostics
    of_packages = [each for each in found if each.code == codes.MISSING_ROS_PACKAGE]
    assert {each.severity for each in of_packages} <= {Severity.WARNING}
    return [(marked(text, each), each.message) for each in of_packages]


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        ("subscribe a to 'o' of message_type Odometry\n", [("Odometry", "no nav_msgs in ROS 2")]),
        (
            "create_message o of message_type Path and input none\n",
            [("Path", "no nav_msgs in ROS 2")],
        ),
        # Each package is told once, also beside a line that is not written to its end.
        (
            "subscribe a to 'o' of message_type nav_msgs/Odometry\n"
            "subscribe a to 'p' of message_type Path\n"
            "subscribe a to 't' of message_type TFMessage\n"
            "subscribe a to\n",
            [("nav_msgs/Odometry", "no nav_msgs in ROS 2"), ("TFMessage", "no tf2_msgs in ROS 2")],
        ),
        ("subscribe a to 's' of message_type String\n", []),
        ("subscribe a to 's' of message_type Odometri\n", []),
        ("create_message_type Path with float64 x\nsubscribe a to 's' of message_type Path\n", []),
        (
            "create_node 'b' as b using rospy\nsubscribe b to 'o' of message_type Odometry\n",
            [("Odometry", "no nav_msgs in ROS 1")],
        ),
        # What is built is told what it needs by the build.
        ("create_node 'c' as c using rclcpp\nsubscribe c to 'o' of message_type Odometry\n", []),
    ],
)
def test_a_package_that_is_not_installed_is_told_at_its_first_type(
    lines: str, expected: list[tuple[str, str]]
) -> None:
    assert told(NODE + lines) == expected
