"""The process that runs nodes, with another program in its place: no ROS is needed."""

from __future__ import annotations

import sys
import threading
from pathlib import Path

import pytest

from plastron_tui.session import Options
from plastron_tui.studio import running

FLOODS_WHEN_STOPPED = """
import signal, sys, time

def flood(*_):
    for number in range(4000):
        print(f"a | {number} {'x' * 200}")
    print("plastron | a was ended by SIGINT", flush=True)
    sys.exit(130)

signal.signal(signal.SIGINT, flood)
print("ready", flush=True)
time.sleep(60)
"""


def test_of_what_is_printed_at_the_end_only_the_end_is_shown_to_who_has_stopped_it(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(running, "_command", lambda *_: [sys.executable, "-c", FLOODS_WHEN_STOPPED])
    is_told = threading.Event()
    run = running.Running(Path("talk.plastron"), Options(), is_told.set)
    try:
        lines: list[str] = []
        while "ready" not in lines:
            assert is_told.wait(60)
            lines = run.take()
        run.stop()
        while run.status is None:
            is_told.wait(0.05)
        lines = []
        while run.has_more:
            lines += run.take()
        assert run.was_stopped
        assert lines[-1] == "plastron | a was ended by SIGINT"
        assert "lines left out" in lines[0]
        assert sum(map(len, lines)) < 2 * running.AT_ONCE
    finally:
        run.close()
