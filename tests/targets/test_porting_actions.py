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


HEAD = {
    "rospy": "import actionlib\nimport rospy\nfrom actionlib_msgs.msg import GoalStatus\n"
    "from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal\nrospy.init_node('n')\n"
    "client = actionlib.SimpleActionClient('move', MoveBaseAction)\n"
    "server = actionlib.SimpleActionServer('dig', DigAction, auto_start=False)\n",
    "rclpy": "import rclpy\nfrom rclpy.action import ActionClient, ActionServer\n"
    "from nav2_msgs.action import NavigateToPose\nrclpy.init()\nnode = rclpy.create_node('n')\n"
    "client = ActionClient(node, NavigateToPose, 'move')\n",
}
HANDED = "the callback of an action takes"
USES = [
    ("rospy", "client.wait_for_server()", ""),
    ("rospy", "client.wait_for_server(timeout)", ".wait_for_server"),
    ("rospy", "client.send_goal(goal)", ".send_goal"),
    ("rospy", "client.wait_for_result()", ".wait_for_result"),
    ("rospy", "x = client.get_result()", ".get_result"),
    ("rospy", "x = client.get_state() == 3", ".get_state"),
    ("rospy", "x = state == GoalStatus.SUCCEEDED", "GoalStatus.SUCCEEDED"),
    ("rospy", "client.cancel_goal()", ".cancel_goal"),
    ("rospy", "def stop(held): held.cancel_all_goals()", ".cancel_all_goals"),
    ("rospy", "def stop(my_client): return my_client.get_state()", ".get_state"),
    ("rospy", "def ask(light): return light.get_state()", ""),
    ("rospy", "server.start()", ".start"),
    ("rospy", "server.set_succeeded()", ".set_succeeded"),
    ("rospy", "if server.is_preempt_requested(): pass", ".is_preempt_requested"),
    ("rospy", "def go(thread): thread.start()", ""),
    ("rospy", "goal = MoveBaseGoal()\ngoal.target_pose = p", ".target_pose"),
    ("rospy", "class A:\n    def send_goal(self): pass\na = A()\na.send_goal()", ""),
    (
        "rospy",
        "def dig(goal): pass\nx = actionlib.SimpleActionServer('a', DigAction, dig, False)",
        f"{HANDED} a goal handle",
    ),
    (
        "rospy",
        "def done(state, result): pass\nclient.send_goal(goal, done)",
        "the done_cb of a goal",
    ),
    (
        "rospy",
        "def heard(feedback): pass\nclient.send_goal(goal, feedback_cb=heard)",
        "the feedback_cb of a goal",
    ),
    ("rclpy", "client.wait_for_server()", ""),
    ("rclpy", "client.wait_for_server(timeout_sec=1.0)", ".wait_for_server"),
    ("rclpy", "client.send_goal(goal)", ".send_goal"),
    ("rclpy", "future = client.send_goal_async(goal)", ".send_goal_async"),
    ("rclpy", "def go(future): return future.result()", ".result"),
    ("rclpy", "def go(future): future.add_done_callback(go)", ".add_done_callback"),
    ("rclpy", "def go(game): return game.result()", ""),
    ("rclpy", "def go(goal_handle): goal_handle.succeed()", ".succeed"),
    ("rclpy", "def go(goal_handle): x = goal_handle.request", ".request"),
    ("rclpy", "def go(web): x = web.request", ""),
    ("rclpy", "def go(handle): handle.publish_feedback(x)", ".publish_feedback"),
    ("rclpy", "def go(handle): x = handle.get_result_async()", ".get_result_async"),
    (
        "rclpy",
        "def dig(goal_handle): pass\nx = ActionServer(node, NavigateToPose, 'd', dig)",
        f"{HANDED} the goal",
    ),
    (
        "rclpy",
        "def heard(message): pass\nclient.send_goal_async(goal, feedback_callback=heard)",
        "the feedback_callback of a goal",
    ),
]


@pytest.mark.parametrize(("library", "lines", "what"), USES)
def test_a_use_of_an_action_is_marked(library: str, lines: str, what: str) -> None:
    text, found = ported(f"{HEAD[library]}{lines}\n", library)
    ast.parse(text)
    known = {each.message.split("`")[1] for each in ported(HEAD[library], library)[1]}
    marked = [each for each in found if each.message.split("`")[1] == what]
    assert len(marked) == bool(what)
    assert all(each.help for each in marked)
    if what:
        comments = [each for each in text.split("\n") if each.lstrip().startswith(MARK)]
        assert any(each.endswith(what) for each in comments)
    else:
        assert {each.message.split("`")[1] for each in found} == known
        assert text.endswith(f"\n{lines}\n")
