"""Nodes that are said to run, and a monitor of them that needs no ROS."""

from __future__ import annotations

import json
import os
import sys
from pathlib import Path
from typing import Any

import pytest
from studio_driver import Driver

from plastron_tui.runtime.monitor import MonitorCommand
from plastron_tui.studio import running
from plastron_tui.studio.panels.live_panel import LivePanel

STAND_IN = Path(__file__).with_name("monitor_stand_in.py")


class Nodes:
    """Nodes that are said to run until they are stopped."""

    monitors: tuple[MonitorCommand, ...] = ()
    is_started = True
    has_more = False

    def __init__(self, path: Path, options: object, news: Any) -> None:
        self.status: int | None = None
        self.was_stopped = False
        # Those that are started later may have others.
        self.monitors = type(self).monitors
        self._news = news
        news()

    def take(self) -> list[str]:
        return []

    def stop(self) -> None:
        self.status, self.was_stopped = 130, True
        self._news()

    close = stop


def watch_stand_in(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Let nodes be said to run; return the file in which their monitor notes what it is asked."""
    log = tmp_path / "orders"
    log.touch()
    command = (sys.executable, str(STAND_IN), str(log))
    monkeypatch.setattr(Nodes, "monitors", (MonitorCommand(2, command, dict(os.environ)),))
    monkeypatch.setattr(running, "Running", Nodes)
    return log


def asked(orders: Path, what: str) -> list[dict[str, Any]]:
    """Return what the monitor was asked of a kind."""
    found = [json.loads(line) for line in orders.read_text().splitlines()]
    return [each for each in found if each["do"] == what]


def live(driver: Driver) -> LivePanel:
    panel = driver.main.panels["live"]
    assert isinstance(panel, LivePanel)
    return panel


async def wait_shown(driver: Driver, text: str) -> str:
    await driver.until(lambda: any(text in line for line in live(driver).lines))
    return next(line for line in live(driver).lines if text in line)
