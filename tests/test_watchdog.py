"""A process in which a test hangs is ended; few tests start the thread that does it."""

from __future__ import annotations

import pytest
import watchdog


def test_the_tests_of_a_minute_share_a_thread(monkeypatch: pytest.MonkeyPatch) -> None:
    now, limits, ended = [0.0], [], []

    def count(limit: float, **options: object) -> None:
        assert options["exit"] is True
        limits.append((now[0], limit))

    monkeypatch.setattr(watchdog.time, "monotonic", lambda: now[0])
    monkeypatch.setattr(watchdog.faulthandler, "dump_traceback_later", count)
    monkeypatch.setattr(
        watchdog.faulthandler, "cancel_dump_traceback_later", lambda: ended.append(now[0])
    )
    watch = watchdog.Watchdog()
    for begin in (0.0, 1.0, 59.0, 61.0, 62.0, 500.0):
        now[0] = begin
        watch.pytest_runtest_logstart()
    watch.pytest_unconfigure()
    assert limits == [(0.0, 1800), (61.0, 1800), (500.0, 1800)]
    assert ended == [500.0]


def test_this_run_is_watched(pytestconfig: pytest.Config) -> None:
    assert isinstance(pytestconfig.pluginmanager.get_plugin("watchdog"), watchdog.Watchdog)
