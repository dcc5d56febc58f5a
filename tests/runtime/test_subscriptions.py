"""What a monitor listens to goes on, whatever is wrong with a single topic."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any
from unittest.mock import MagicMock

import pytest

import plastron_tui.runtime.observers as observers


class Heard:
    """A subscription that fails where it is told to."""

    class Topic:
        is_full = False

        def report(self) -> dict[str, Any]:
            return {"count": 1, "rate": 1.0, "text": "heard", "number": None}

    def __init__(self, fails: Callable[[str], None], name: str) -> None:
        self.topic = self.Topic()
        self._fails, self._name = fails, name
        fails(f"make {name}")

    def take(self) -> None:
        self._fails(f"take {self._name}")

    def look(self) -> None:
        self._fails(f"look {self._name}")

    def close(self) -> None:
        self._fails(f"close {self._name}")


@pytest.mark.parametrize("step", ["make", "take", "look"])
@pytest.mark.parametrize(
    "error",
    [RuntimeError("no type support"), SyntaxError("bad package"), OSError(5, "gone"), KeyError()],
)
def test_what_fails_with_a_topic_is_told_in_its_row(
    monkeypatch: pytest.MonkeyPatch, step: str, error: Exception
) -> None:
    monkeypatch.syspath_prepend(str(Path(observers.__file__).parent))
    import monitor_subscriptions

    told: dict[str, str] = {}
    monkeypatch.setattr(
        monitor_subscriptions,
        "send",
        lambda tell, rows: told.update({name: row["text"] for name, row in rows.items()}),
    )
    broken = {f"{step} /b", "close /b"}

    def fails(where: str) -> None:
        if where in broken:
            raise error

    topics = monitor_subscriptions.Subscriptions(lambda name, _: Heard(fails, name))
    topics.types = dict.fromkeys(("/a", "/b", "/c"), "a/B")
    topics.watch(["/a", "/b", "/c", "/unknown"], ["/c"])
    topics.take()
    topics.look()
    assert told.pop("/b") == f"cannot be heard: {str(error) or 'KeyError'}"
    topics.report()
    assert told == dict.fromkeys(["/a", "/c", *(["/b"] if topics.hears("/b") else [])], "heard")
    assert topics.hears("/a") and topics.hears("/c") and not topics.hears("/unknown")
    # It is tried again.
    broken.clear()
    topics.look()
    topics.watch(["/b"], ["/b"])
    told.clear()
    topics.report()
    assert told == {"/b": "heard"} and topics
    topics.watch([], [])
    assert not topics


def test_a_type_that_is_not_there_is_told_as_that(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(str(Path(observers.__file__).parent))
    import monitor_subscriptions

    told: list[str] = []
    monkeypatch.setattr(
        monitor_subscriptions, "send", lambda tell, rows: told.append(rows["/a"]["text"])
    )

    def make(name: str, type_name: str) -> Any:
        raise monitor_subscriptions.NotInstalledError(type_name)

    topics = monitor_subscriptions.Subscriptions(make)
    topics.types = {"/a": "pkg/Type"}
    topics.watch(["/a"], [])
    topics.look()
    assert told == ["pkg/Type is not installed here"]


class Client:
    """A client of a node's parameters: the node answers with nothing that fits."""

    def service_is_ready(self) -> bool:
        return True

    def call_async(self, request: Any) -> Any:
        answer = SimpleNamespace(results=[], result=None)
        return SimpleNamespace(done=lambda: True, result=lambda: answer, exception=lambda: None)


def test_a_node_that_answers_nonsense_is_asked_again(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(str(Path(observers.__file__).parent))
    kinds = ("DescribeParameters", "GetParameters", "ListParameters", "SetParameters")
    kind = SimpleNamespace(Request=lambda **_: None)
    parameter = SimpleNamespace(Parameter=MagicMock(), parameter_value_to_python=None)
    monkeypatch.setitem(sys.modules, "rcl_interfaces", SimpleNamespace())
    services = SimpleNamespace(**dict.fromkeys(kinds, kind))
    monkeypatch.setitem(sys.modules, "rcl_interfaces.srv", services)
    monkeypatch.setitem(sys.modules, "rclpy", SimpleNamespace())
    monkeypatch.setitem(sys.modules, "rclpy.parameter", parameter)
    monkeypatch.delitem(sys.modules, "monitor_parameters", raising=False)
    import monitor_parameters

    asked: list[str] = []

    def create_client(kind: Any, name: str) -> Client:
        asked.append(name)
        if name.startswith("/wrong name"):
            raise ValueError("no name of a service")
        return Client()

    caller = SimpleNamespace(create_client=create_client, destroy_client=lambda client: None)
    parameters = monitor_parameters.Parameters(caller)
    parameters.nodes = frozenset({"/a", "/wrong name"})
    parameters.watch(["/a", "/wrong name"])
    for now in range(10, 30):
        parameters.turn(float(now))
    assert sum(name.startswith("/wrong name") for name in asked) > 3
    assert sum(name == "/a/list_parameters" for name in asked) > 3
    # What is set while the node is asked makes it be asked anew.
    steps: list[Any] = []
    parameters.watch(["/a"])
    parameters.turn(40.0)
    parameters.turn(40.1)
    assert parameters.is_asking
    good = SimpleNamespace(results=[SimpleNamespace(successful=True, reason="")])
    future = SimpleNamespace(done=lambda: True, result=lambda: good)
    monkeypatch.setattr(Client, "call_async", lambda self, request: future)
    monkeypatch.setattr(monitor_parameters, "answer", lambda *_, **__: None)
    order = {"node": "/a", "name": "x", "value": 1}
    parameters.set(order, lambda order, step: steps.append(step))
    assert steps[0](False)
    parameters.turn(41.0)
