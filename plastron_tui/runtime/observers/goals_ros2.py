"""Goals that the studio's monitor sends to action servers of ROS 2."""

from __future__ import annotations

import importlib
import time
from collections.abc import Iterable
from typing import Any

from action_msgs.msg import GoalStatus
from message_filling import fill
from monitor_goals import CANCELING, Goal, Goals
from plastron_text import line_of
from rclpy.action import ActionClient

_ENDS = {
    GoalStatus.STATUS_SUCCEEDED: "succeeded",
    GoalStatus.STATUS_CANCELED: "canceled",
    GoalStatus.STATUS_ABORTED: "aborted",
}
FEEDBACK = "/_action/feedback"
STATUS = "/_action/status"
_FEEDBACK_TYPE = "_FeedbackMessage"
_LOST = 2.0
"""Seconds without its server after which nobody waits for a goal's result any more."""


def action_types(topics: Iterable[tuple[str, list[str]]]) -> dict[str, str]:
    """Return the types of the actions whose topics these are, by their names.

    Source: the ROS 2 design page "Actions" has the names of an action's topics.
    """
    return {
        name.removesuffix(FEEDBACK): types[0].removesuffix(_FEEDBACK_TYPE).replace("/action/", "/")
        for name, types in topics
        if name.endswith(FEEDBACK) and types[0].endswith(_FEEDBACK_TYPE)
    }


class ActionClients:
    """A client for each action that goals were sent to.

    They stay: what a client has asked for would be lost with it.
    """

    def __init__(self, node: Any) -> None:
        """Start with none; `node` is spun by who has it as long as goals are not over."""
        self._node = node
        self._clients: dict[tuple[str, str], tuple[Any, Any]] = {}

    def __contains__(self, name: str) -> bool:
        """Tell whether there is one of an action."""
        return any(known == name for known, _ in self._clients)

    def send(self, order: dict[str, Any], goals: Goals) -> None:
        """Send a goal, as soon as somebody provides the action."""
        key = order["name"], order["type"]
        if key not in self._clients:
            package, type_name = order["type"].split("/")
            action = getattr(importlib.import_module(f"{package}.action"), type_name)
            self._clients[key] = action, ActionClient(self._node, action, order["name"])
        action, client = self._clients[key]
        goals.add(order["id"], _Sent(order, client, fill(action.Goal(), order["values"])))


class _Sent:
    """A goal that is sent, worked on and canceled by futures, which are looked at in each turn."""

    def __init__(self, order: dict[str, Any], client: Any, values: Any) -> None:
        self.goal = Goal(order, values)
        self._client = client
        self._values = values
        self._accepting: Any = None
        self._handle: Any = None
        self._result: Any = None
        self._is_canceled = False
        self._seen_at = 0.0

    def turn(self) -> None:
        """Take what came."""
        try:
            self._step()
        except Exception as error:  # whatever a foreign node answers
            self.goal.note("failed", str(error) or type(error).__name__, is_over=True)

    def _step(self) -> None:
        now, is_ready = time.monotonic(), self._client.server_is_ready()
        self._seen_at = now if is_ready else self._seen_at
        if self._accepting is None:
            if is_ready:
                self.goal.note("sent")
                self._accepting = self._client.send_goal_async(
                    self._values, feedback_callback=lambda each: self.goal.see(each.feedback)
                )
            return
        if self._handle is None and self._accepting.done():
            self._handle = self._accepting.result()
            if not self._handle.accepted:
                self.goal.note("rejected", is_over=True)
                return
            self.goal.note("accepted")
            self._result = self._handle.get_result_async()
            if self._is_canceled:
                self._handle.cancel_goal_async()
        if self._result is not None and self._result.done():
            found = self._result.result()
            self.goal.report()
            self.goal.note(_ENDS.get(found.status, "lost"), line_of(found.result), is_over=True)
        elif now - self._seen_at > _LOST:
            self.goal.note("lost", "who works on it is gone", is_over=True)

    def cancel(self) -> None:
        """Ask the server to leave it; one that was not sent is not sent any more."""
        if self._accepting is None:
            self.goal.note("canceled", is_over=True)
            return
        self._is_canceled = True
        self.goal.note(CANCELING)
        if self._handle is not None:
            self._handle.cancel_goal_async()
