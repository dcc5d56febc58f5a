"""What became of the goals that a monitor has sent, as it tells the studio."""

from __future__ import annotations

import threading
from typing import Any

from monitor_pipes import send
from plastron_text import line_of

CANCELING = "is being canceled"
_FAILED = frozenset({"rejected", "aborted", "lost", "failed"})
_MOST_ENDED = 20
"""So many goals that are over are kept for the answers that may still come."""


class Goal:
    """A goal, and what is known of it. Each thing is told once, feedback the last of a turn."""

    def __init__(self, order: dict[str, Any], goal: Any) -> None:
        """Tell that a goal is on its way.

        Args:
            order: what the studio wants, with a number and the action's name.
            goal: the goal, as a message.
        """
        self.is_over = False
        self._order = order
        self._sent = line_of(goal)
        self._state = ""
        self._feedback: Any = None
        self._lock = threading.Lock()
        self.note("waits for a server")

    def note(self, state: str, text: str = "", *, is_over: bool = False) -> None:
        """Tell how far it is. After its end nothing is told, nor while it ends that it goes on."""
        with self._lock:
            if self.is_over or (self._state == CANCELING and not is_over):
                return
            self._state, self.is_over, self._feedback = state, is_over, None
            self._tell(text)

    def see(self, feedback: Any) -> None:
        """Note feedback; it is told with the next report."""
        with self._lock:
            self._feedback = feedback

    def report(self) -> None:
        """Tell the last feedback, where none was told since it came."""
        with self._lock:
            feedback, self._feedback = self._feedback, None
            if feedback is not None and not self.is_over:
                self._tell(line_of(feedback))

    def _tell(self, text: str) -> None:
        send(tell="goal", id=self._order["id"], name=self._order["name"], sent=self._sent,
             state=self._state, text=text, is_over=self.is_over,
             is_failure=self._state in _FAILED)  # fmt: skip


class Goals:
    """The goals that were sent, by their numbers, each with what is needed to cancel it."""

    def __init__(self) -> None:
        """Start with none."""
        self._known: dict[int, Any] = {}

    def __bool__(self) -> bool:
        """Tell whether one is not over yet."""
        return any(not each.goal.is_over for each in self._known.values())

    def add(self, number: int, sent: Any) -> None:
        """Keep one; `sent` has its `goal` (a `Goal`), and `turn` and `cancel`."""
        self._known[number] = sent
        ended = [number for number, each in self._known.items() if each.goal.is_over]
        for each in ended[:-_MOST_ENDED]:
            del self._known[each]

    def cancel(self, number: int) -> None:
        """Ask who works on one to leave it."""
        sent = self._known.get(number)
        if sent is not None and not sent.goal.is_over:
            sent.cancel()

    def turn(self) -> None:
        """Go on with those that are not over."""
        for each in list(self._known.values()):
            if not each.goal.is_over:
                each.turn()

    def report(self) -> None:
        """Tell the feedback that came."""
        for each in list(self._known.values()):
            each.goal.report()
