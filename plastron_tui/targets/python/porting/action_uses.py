"""What is asked of action clients, servers and goals, which each ROS does in a way of its own.

Sources: `actionlib` of noetic; `rclpy.action` of kilted; `GoalStatus` of both.
"""

from __future__ import annotations

from collections.abc import Mapping

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind
from plastron_tui.sources.python.arguments import Arguments
from plastron_tui.sources.python.calls import Argument
from plastron_tui.sources.python.scopes import BindingKind
from plastron_tui.sources.python.syntax import parts_of

from .port_state import Work, is_imported, walk

_ACTIONS = frozenset({EndpointKind.ACTION_CLIENT, EndpointKind.ACTION_SERVER})
_CLASSES = ("actionlib.", "rclpy.action.")

_GOAL_CALLBACKS = "`goal_callback` and `handle_accepted_callback` of the `ActionServer`"
_EACH_HANDLE = "`cancel_goal_async()` of each goal handle"
_OF_ROS_1 = {
    "send_goal": "`send_goal_async(goal, feedback_callback=...)`, whose future is a goal handle",
    "send_goal_and_wait": "`send_goal_async(goal)`, then `get_result_async()` of the goal handle",
    "wait_for_result": "the future of `get_result_async()` of the goal handle",
    "get_goal_status_text": "a goal of ROS 2 has no text",
    "cancel_goal": "`cancel_goal_async()` of the goal handle",
    "cancel_all_goals": _EACH_HANDLE,
    "cancel_goals_at_and_before_time": _EACH_HANDLE,
    "stop_tracking_goal": "leave the future of the goal alone",
    "wait_for_server": "it takes `timeout_sec`, a number of seconds",
    "set_succeeded": "`succeed()` of the goal handle, and return the result",
    "set_aborted": "`abort()` of the goal handle, and return the result",
    "set_preempted": "`canceled()` of the goal handle, and return the result",
    "set_canceled": "`canceled()` of the goal handle, and return the result",
    "set_accepted": "return `GoalResponse.ACCEPT` from `goal_callback`",
    "set_rejected": "return `GoalResponse.REJECT` from `goal_callback`",
    "publish_feedback": "`publish_feedback(...)` of the goal handle",
    "is_preempt_requested": "`is_cancel_requested` of the goal handle",
    "is_new_goal_available": _GOAL_CALLBACKS,
    "accept_new_goal": _GOAL_CALLBACKS,
    "register_goal_callback": _GOAL_CALLBACKS,
    "register_preempt_callback": "`cancel_callback` of the `ActionServer`",
    "get_result": "`result` of what the future of `get_result_async()` gives",
    "get_state": "`status` of what the future of `get_result_async()` gives: other numbers",
    "get_goal": "`request` of the goal handle",
    "get_goal_id": "`goal_id` of the goal handle",
    "is_active": "`is_active` of the goal handle, which is no method",
    "start": "an `ActionServer` serves as soon as it is made",
}
_OF_ROS_2 = {
    "send_goal_async": "`send_goal(goal, feedback_cb=...)`, then `wait_for_result()`",
    "get_result_async": "`wait_for_result()` of the client, then `get_result()`",
    "cancel_goal_async": "`cancel_goal()` of the client",
    "server_is_ready": "`wait_for_server` of the client",
    "wait_for_server": "it takes a `rospy.Duration`",
    "is_cancel_requested": "`is_preempt_requested()` of the server",
    "publish_feedback": "`publish_feedback(...)` of the server",
    "send_goal": "it does not wait for the result: `send_goal_and_wait(goal)`",
    "succeed": "`set_succeeded(result)` of the server",
    "abort": "`set_aborted(result)` of the server",
    "canceled": "`set_preempted(result)` of the server",
    "request": "rospy hands over the goal itself",
    "accepted": "`get_state()` of the client: `GoalStatus.REJECTED` is not accepted",
    "is_active": "`is_active()` of the server",
    "execute": "a server of `actionlib` calls its `execute_cb` by itself",
    "add_done_callback": "`done_cb` of `send_goal`; a service's client waits by itself",
    "result": "rospy has no futures: a client gives the answer itself",
}
_COMMON = {
    "get_result": ("client", "action", "goal"),
    "get_state": ("client", "action", "goal"),
    "get_goal": ("goal", "gh"),
    "get_goal_id": ("goal", "gh"),
    "is_active": ("action", "server", "goal"),
    "start": ("action_server",),
    "send_goal": ("client", "action"),
    "succeed": ("goal",),
    "abort": ("goal",),
    "canceled": ("goal",),
    "request": ("goal",),
    "accepted": ("goal",),
    "execute": ("goal",),
    "result": ("future",),
}
"""What other things have as well, and what a name says of one that nobody knows."""

_HANDED = {
    1: ("the callback of an action takes the goal", "the server takes its result: `set_succeeded`"),
    2: (
        "the callback of an action takes a goal handle",
        "`request` of it is the goal, and the callback returns the result",
    ),
}
_LATER = {
    "done_cb": "it takes a future in ROS 2, and the result is in `result` of what that gives",
    "feedback_cb": "it takes a message in ROS 2, with the feedback in `feedback`",
    "feedback_callback": "`feedback_cb` of `actionlib` takes the feedback itself",
}
"""What the functions take that a goal is sent with."""

_STATES = {
    "PENDING": "STATUS_ACCEPTED",
    "ACTIVE": "STATUS_EXECUTING",
    "PREEMPTING": "STATUS_CANCELING",
    "SUCCEEDED": "STATUS_SUCCEEDED",
    "PREEMPTED": "STATUS_CANCELED",
    "ABORTED": "STATUS_ABORTED",
}
_STATUS = "actionlib_msgs.msg.GoalStatus."
_FIELDS = {"move_base_msgs.msg.MoveBaseGoal": {"target_pose": "`pose` of `NavigateToPose.Goal`"}}
"""Fields of goals that go by another name, by the class."""


def mark_action_uses(work: Work) -> None:
    """Mark each use of an action client, a server or a goal that means another thing there."""
    version = work.catalog.ros_version
    sites = [each for each in work.analysis.sites if each.endpoint.kind in _ACTIONS]
    table = _OF_ROS_1 if version == 2 else _OF_ROS_2
    text = work.analysis.syntax.text
    has_actions = bool(sites) or b"actionlib" in text or b"rclpy.action" in text
    for node in walk(work.analysis.syntax.root):
        part = node.child_by_field_name("attribute") if node.type == "attribute" else None
        if part is None or work.is_gone(node) or is_imported(node) or node.id in work.done:
            continue
        name = work.slice(part)
        if name in table and _is_action(work, node, name, has_actions=has_actions):
            work.mark(node, f".{name}", table[name])
        elif version == 2:
            _mark_constant_or_field(work, node, name)
    for site in sites:
        function = work.callback_of(site)
        if function is not None:
            work.mark(function.node, *_HANDED[version])
    for call in work.analysis.captures.get("call", []) if has_actions else ():
        _mark_later(work, call)


def _mark_later(work: Work, call: Node) -> None:
    """Mark the functions of the file that a goal is sent with."""
    callee = call.child_by_field_name("function")
    part = callee.child_by_field_name("attribute") if callee is not None else None
    if part is None or not work.slice(part).startswith("send_goal"):
        return
    given = Arguments.of(call, work.analysis.syntax)
    for position, word in ((1, "done_cb"), (3, "feedback_cb"), (-1, "feedback_callback")):
        function = given.get(Argument(position, word))
        for each in work.bindings(function) if function is not None else ():
            if each.kind is BindingKind.FUNCTION and each.owner is not None:
                work.mark(each.owner.node, f"the {word} of a goal", _LATER[word])


def _is_action(work: Work, node: Node, name: str, *, has_actions: bool) -> bool:
    """Tell whether an attribute is one of an action, as far as the file says it."""
    holder, call = node.child_by_field_name("object"), node.parent
    if holder is None or work.analysis.resolver.attribute_bindings(node, work.scope(node)):
        return False
    # Without a limit it is the same in both.
    arguments = call.child_by_field_name("arguments") if call is not None else None
    if name == "wait_for_server" and not parts_of(arguments):
        return False
    made = work.analysis.resolver.instance(holder, work.scope(holder))
    if made is not None and made.qualified:
        return made.qualified.startswith(_CLASSES)
    words = _COMMON.get(name)
    last = work.slice(holder).rpartition(".")[2].lower()
    is_future = words is not None and "future" in words
    return words is None or ((has_actions or is_future) and any(each in last for each in words))


def _mark_constant_or_field(work: Work, node: Node, name: str) -> None:
    holder = node.child_by_field_name("object")
    if holder is None:
        return
    if f"{_STATUS}{name}" in work.qualified(node) and name.isupper():
        new = _STATES.get(name)
        remedy = f"`{new}` of `action_msgs.msg.GoalStatus`" if new else "ROS 2 has no such state"
        work.mark(node, f"GoalStatus.{name}", remedy)
        return
    made = work.analysis.resolver.instance(holder, work.scope(holder))
    fields: Mapping[str, str] = _FIELDS.get(made.qualified, {}) if made is not None else {}
    if name in fields:
        work.mark(node, f".{name}", fields[name])
