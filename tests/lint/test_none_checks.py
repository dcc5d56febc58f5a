"""What RM202 tells of None, where checks keep it away and where they do not."""

from __future__ import annotations

from textwrap import dedent, indent

import pytest
from message_programs import marked, node, told

_EMPTY = "def start(self):\n    self.goal = None\n\ndef tick(self):\n"


def _checked(lines: str) -> str:
    return node(_EMPTY + indent(dedent(lines).strip("\n"), "    "))


CHECKED = {
    "no check": "self.twists.publish(self.goal)  # wrong",
    "a check of something else": """
        if self.goals is None or self.late:
            return
        String(data=self.goal)  # wrong
    """,
    "a check that goes on": """
        if self.goal is None:
            pass
        String(data=self.goal)  # wrong
    """,
    "a check that None may pass": """
        if self.goal is None and self.late:
            return
        if self.goal is not None:
            return
        String(data=self.goal)  # wrong
    """,
    "the branch of None": """
        if self.goal is None or not self.goal:
            String(data=self.goal)  # wrong
        elif self.goal:
            pass
        if self.goal or self.late:
            String(data=self.goal)  # wrong
        if not (self.goal is not None or self.late):
            String(data=self.goal)  # wrong
        self.goal or self.texts.publish(self.goal)  # wrong
    """,
}


@pytest.mark.parametrize("lines", CHECKED.values(), ids=CHECKED)
def test_named_is_none_that_no_check_keeps_away(lines: str) -> None:
    text = _checked(lines)
    assert told(text, "RM202") == marked(text)


KEPT_AWAY = {
    "a check that leaves before": _checked("""
        if self.goal is None or self.late:
            return
        self.twists.publish(self.goal)
        self.texts.publish(String(data=self.goal))
    """),
    "a check that leaves in the other branch": _checked("""
        if self.goal is not None and self.ready:
            pass
        else:
            raise ValueError
        String(data=self.goal)
    """),
    "checks around": _checked("""
        if self.goal:
            String(data=self.goal)
        if not self.goal:
            pass
        elif self.ready:
            String(data=self.goal)
        while (self.goal != None):
            String(data=self.goal)
        for _ in range(3):
            if not isinstance(self.goal, str):
                continue
            String(data=self.goal)
        String(data=self.goal if self.goal is not None else '')
        self.goal and self.texts.publish(self.goal)
    """),
    "an assertion": _checked("""
        assert self.goal is not None
        String(data=self.goal)
    """),
    "a base of a file that is not read": _checked("String(data=self.goal)").replace(
        "(Node)", "(GoalMixin, Node)"
    ),
    "a class that others may derive from": _checked("String(data=self.goal)")
    .replace("spin(Worker())", "spin(others.Worker())")
    .replace("Worker())", "make())"),
}


@pytest.mark.parametrize("text", KEPT_AWAY.values(), ids=KEPT_AWAY)
def test_nothing_is_told_where_none_does_not_come(text: str) -> None:
    assert told(text, "RM202") == []
