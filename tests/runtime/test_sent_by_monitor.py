"""What a monitor sends, whichever ROS it is of: goals, and messages at a rate."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from machine import wait_until

import plastron_tui.runtime.observers as observers

ORDER: dict[str, Any] = {"id": 7, "name": "/count", "type": "p/Count", "rate": 200}


@pytest.fixture(autouse=True)
def as_scripts(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """The scripts find each other as they do where they run: they stand alone."""
    monkeypatch.syspath_prepend(str(Path(observers.__file__).parent))
    yield


class Message(SimpleNamespace):
    """A message as those of rclpy: it says which fields it has."""

    def get_fields_and_field_types(self) -> dict[str, str]:
        return dict.fromkeys(vars(self), "")


def told(capsys: pytest.CaptureFixture[str]) -> list[dict[str, Any]]:
    return [json.loads(line) for line in capsys.readouterr().out.splitlines()]


def states(capsys: pytest.CaptureFixture[str]) -> list[tuple[str, str]]:
    return [(each["state"], each["text"]) for each in told(capsys)]


def test_a_goal_is_told_to_its_end_and_no_further(capsys: pytest.CaptureFixture[str]) -> None:
    from monitor_goals import CANCELING, Goal

    goal = Goal(ORDER, Message(order=5))
    (first,) = told(capsys)
    assert (first["id"], first["name"], first["sent"]) == (7, "/count", "order: 5")
    goal.note("accepted")
    for count in (1, 2):
        goal.see(Message(count=count))
    goal.report()
    goal.report()
    assert states(capsys) == [("accepted", ""), ("accepted", "count: 2")]
    # What is being canceled does not seem to go on, but its end is told.
    goal.note(CANCELING)
    goal.note("accepted")
    goal.see(Message(count=3))
    goal.note("canceled", "count: 3", is_over=True)
    goal.report()
    goal.note("lost", is_over=True)
    assert states(capsys) == [(CANCELING, ""), ("canceled", "count: 3")]
    assert goal.is_over


@pytest.mark.parametrize(
    ("state", "is_failure"), [("succeeded", False), ("canceled", False), ("aborted", True)]
)
def test_a_goal_that_was_not_reached_has_failed(
    capsys: pytest.CaptureFixture[str], state: str, is_failure: bool
) -> None:
    from monitor_goals import Goal

    Goal(ORDER, Message()).note(state, is_over=True)
    assert told(capsys)[-1]["is_failure"] == is_failure


def test_goals_that_are_over_are_left_alone(capsys: pytest.CaptureFixture[str]) -> None:
    from monitor_goals import Goal, Goals

    goals, done = Goals(), []
    assert not goals
    for number in range(40):
        goal = Goal({**ORDER, "id": number}, Message())
        sent = SimpleNamespace(
            goal=goal,
            turn=lambda number=number: done.append(("turn", number)),
            cancel=lambda number=number: done.append(("cancel", number)),
        )
        goals.add(number, sent)
        if number != 3:
            goal.note("succeeded", is_over=True)
    assert goals
    goals.turn()
    goals.cancel(3)
    goals.cancel(39)
    goals.cancel(99)
    assert done == [("turn", 3), ("cancel", 3)]
    # Those that are over do not become more and more.
    assert len(goals._known) < 25 and 3 in goals._known


def test_what_is_sent_at_a_rate_ends_when_it_is_told_to(
    capsys: pytest.CaptureFixture[str],
) -> None:
    from monitor_sending import Sendings

    sent: list[str] = []
    closed: list[str] = []
    sendings = Sendings()
    for text in ("a", "b"):
        sendings.start(
            ORDER, lambda text=text: sent.append(text), lambda text=text: closed.append(text), text
        )
        wait_until(lambda text=text: sent.count(text) > 2, "messages", 30)
    # The second one took the place of the first one.
    assert closed == ["a"] and "a" not in sent[sent.index("b") :]
    sendings.stop("/other")
    sendings.stop("/count")
    count = len(sent)
    assert closed == ["a", "b"]
    rates = [each["rate"] for each in told(capsys) if each["tell"] == "sending"]
    assert rates == [200, 0, 200, 0]
    assert len(sent) == count
    sendings.stop("/count")
    assert not told(capsys)
    # Without a studio nothing is sent, and nobody told.
    sendings.start(ORDER, lambda: sent.append("c"), lambda: None, "c")
    sendings.close()
    count = sent.count("c")
    assert not sendings._running["/count"][0]._thread.is_alive()
    assert [each.get("rate") for each in told(capsys) if each["tell"] == "sending"] == [200]
    assert sent.count("c") == count


def test_what_cannot_be_sent_is_said_once(capsys: pytest.CaptureFixture[str]) -> None:
    from monitor_sending import Sendings

    tried: list[int] = []
    closed: list[str] = []

    def publish() -> None:
        tried.append(1)
        raise ValueError("no")

    sendings = Sendings()
    sendings.start(ORDER, publish, lambda: closed.append("a"), "a")
    sending, _ = sendings._running["/count"]
    sending._thread.join(30)
    found = told(capsys)
    assert tried == [1]
    assert [(each["rate"], each.get("problem", "")) for each in found[1:]] == [(200, ""), (0, "no")]
    # Its publisher goes, in the thread that made it, and once.
    assert not closed
    sendings.turn()
    sendings.turn()
    sendings.stop("/count")
    assert closed == ["a"] and not sendings._running
    assert not told(capsys)
    # One that sends is left alone.
    sendings.start(ORDER, lambda: None, lambda: closed.append("b"), "b")
    sendings.turn()
    sendings.stop("/count")
    assert closed == ["a", "b"]
