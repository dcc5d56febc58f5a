"""Goals that the studio's monitor sends to action servers of ROS 1."""

from __future__ import annotations

import time
from collections.abc import Iterable, Mapping
from typing import Any

import roslib.message
import rospy
from message_filling import fill
from monitor_goals import CANCELING, Goal, Goals
from monitor_subscriptions import NotInstalledError
from plastron_text import line_of

_GOAL, _TYPE = "/goal", "ActionGoal"
_PARTS = frozenset({"goal", "cancel", "status", "feedback", "result"})


def action_types(types: Mapping[str, str]) -> dict[str, str]:
    """Return the types of the actions whose topics these are, by their names.

    Source: the ROS wiki page "actionlib/DetailedDescription".
    """
    return {
        name.removesuffix(_GOAL): type_.removesuffix(_TYPE)
        for name, type_ in types.items()
        if name.endswith(_GOAL) and type_.endswith(_TYPE)
        and all(f"{name.removesuffix(_GOAL)}/{part}" in types for part in _PARTS)
    }  # fmt: skip


def is_part(name: str, actions: Iterable[str]) -> bool:
    """Tell whether a topic is one of those that an action consists of."""
    action, _, part = name.rpartition("/")
    return part in _PARTS and action in actions


# It looks once, and does not wait: a simulated clock may stand still.
_NOW = rospy.Duration(-1)
_LOST = 5.0
"""Seconds without a word of the server, that says one every fifth of a second."""


class ActionClients:
    """A client for each action that goals were sent to; they stay, for what comes of those."""

    def __init__(self) -> None:
        """Start with none."""
        self._clients: dict[tuple[str, str], tuple[Any, Any]] = {}

    def send(self, order: dict[str, Any], goals: Goals) -> None:
        """Send a goal, as soon as somebody provides the action."""
        key = order["name"], order["type"]
        if key not in self._clients:
            # Only who sends a goal needs it to be installed.
            import actionlib

            action = roslib.message.get_message_class(f"{order['type']}Action")
            if action is None:
                raise NotInstalledError(order["type"])
            self._clients[key] = action, actionlib.ActionClient(order["name"], action)
        action, client = self._clients[key]
        goal = type(action().action_goal.goal)()
        goals.add(order["id"], _Sent(order, client, fill(goal, order["values"])))


class _Sent:
    """A goal; what comes of it is told by threads of rospy."""

    def __init__(self, order: dict[str, Any], client: Any, values: Any) -> None:
        self.goal = Goal(order, values)
        self._client = client
        self._values = values
        self._handle: Any = None
        self._status: Any = None
        self._seen_at = 0.0

    def turn(self) -> None:
        """Send it, where that was not done yet and somebody takes it; or see it lost."""
        now, status = time.monotonic(), self._client.last_status_msg
        if status is not self._status:
            self._status, self._seen_at = status, now
        if self._handle is not None:
            if now - self._seen_at > _LOST:
                self.goal.note("lost", "who works on it is gone", is_over=True)
        elif self._client.wait_for_server(_NOW):
            self.goal.note("sent")
            self._handle = self._client.send_goal(self._values, self._changed, self._see)

    def cancel(self) -> None:
        """Ask the server to leave it; one that was not sent is not sent any more."""
        if self._handle is None:
            self.goal.note("canceled", is_over=True)
            return
        self.goal.note(CANCELING)
        self._handle.cancel()

    def _see(self, _: Any, feedback: Any) -> None:
        self.goal.see(feedback)

    def _changed(self, handle: Any) -> None:
        from actionlib import CommState, TerminalState

        state = handle.get_comm_state()
        if state == CommState.ACTIVE:
            self.goal.note("accepted")
        elif state == CommState.DONE:
            result = handle.get_result()
            text = handle.get_goal_status_text() if result is None else line_of(result)
            word = TerminalState.to_string(handle.get_terminal_state()).lower()
            self.goal.report()
            self.goal.note(word, text, is_over=True)
