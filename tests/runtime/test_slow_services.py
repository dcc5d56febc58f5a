"""A service that does not answer keeps no monitor waiting."""

from __future__ import annotations

import threading
from pathlib import Path

import pytest
from machine import wait_until

import plastron_tui.runtime.observers as observers


@pytest.fixture(autouse=True)
def as_scripts(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(str(Path(observers.__file__).parent))


def test_types_are_asked_for_aside_and_failures_remembered(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    import monitor_services

    may_answer, asked = threading.Event(), []

    def ask(name: str) -> str:
        asked.append(name)
        assert may_answer.wait(60)
        if name == "/hangs" and asked.count(name) == 1:
            raise OSError("timed out")
        return "std_srvs/Empty"

    types = monitor_services.ServiceTypes(ask)
    assert (types.of("/hangs"), types.of("/good")) == ("", "")
    may_answer.set()
    wait_until(lambda: types.of("/good") == "std_srvs/Empty", "the type is known", 60)
    assert types.of("/hangs") == "" and asked == ["/hangs", "/good"]
    later = monitor_services.time.monotonic() + 60
    monkeypatch.setattr(monitor_services.time, "monotonic", lambda: later)
    wait_until(lambda: types.of("/hangs") == "std_srvs/Empty", "it is asked again", 60)


def test_a_call_is_waited_for_within_a_limit() -> None:
    import monitor_services

    never = threading.Event()
    assert monitor_services.within(0.01, lambda: str(never.wait(60))) is None
    never.set()
    assert monitor_services.within(60, lambda: "sum: 3") == "sum: 3"
    with pytest.raises(OSError, match="refused"):
        monitor_services.within(60, lambda: str(_refused()))


def _refused() -> None:
    raise OSError("refused")
