"""Classes of actions, which the other ROS calls otherwise, are marked: before → after."""

from __future__ import annotations

import ast

import pytest
from ported_nodes import MARK, ported

NODES = {
    "rospy": ("import rospy\n", "rospy.init_node('n')\n"),
    "rclpy": ("import rclpy\n", "rclpy.init()\nrclpy.create_node('n')\n"),
}
MARKED = [
    ("rospy", "from move_base_msgs.msg import MoveBaseAction as A", "A", "MoveBaseAction"),
    ("rospy", "from move_base_msgs.msg import MoveBaseGoal", "MoveBaseGoal()", "MoveBaseGoal"),
    ("rospy", "import move_base_msgs.msg", "move_base_msgs.msg.MoveBaseGoal()", "MoveBaseGoal"),
    ("rospy", "from my_msgs.msg import DigAction, DigGoal", "DigGoal()", "DigGoal"),
    ("rospy", "from my_msgs.msg import DigGoal", "DigGoal()", ""),
    ("rospy", "from my_msgs.msg import DigActionResult", "DigActionResult()", "DigActionResult"),
    ("rclpy", "from control_msgs.action import GripperCommand as G", "G.Goal()", "GripperCommand"),
    ("rclpy", "import my_msgs.action", "x = my_msgs.action.Dig", "Dig"),
    (
        "rclpy",
        "from action_msgs.msg import GoalStatus",
        "x = GoalStatus.STATUS_UNKNOWN",
        "STATUS_UNKNOWN",
    ),
]


@pytest.mark.parametrize(("library", "imports", "line", "what"), MARKED)
def test_an_action_is_marked(library: str, imports: str, line: str, what: str) -> None:
    head, made = NODES[library]
    text, found = ported(f"{head}{imports}\n{made}{line}\n", library)
    ast.parse(text)
    mark = f"{MARK}{what}\n" if what else ""
    assert text.endswith(f"\n{mark}{line}\n")
    is_listed = imports.startswith("from") and "GoalStatus" not in imports
    assert bool(what and is_listed) == any(
        MARK in above and "import" in below
        for above, below in zip(text.split("\n"), text.split("\n")[1:], strict=False)
    )
    assert bool(what) == bool(found)


def test_the_end_of_a_goal() -> None:
    text, _ = ported(
        "import rclpy\nfrom action_msgs.msg import GoalStatus\nrclpy.init()\n"
        "rclpy.create_node('n')\nx = s == GoalStatus.STATUS_SUCCEEDED\n",
        "rclpy",
    )
    assert "from actionlib_msgs.msg import GoalStatus\n" in text
    assert text.endswith("\nx = s == GoalStatus.SUCCEEDED\n")
