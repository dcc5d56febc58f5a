"""An event loop that knows when all its tasks wait, so that tests need not wait for time."""

from __future__ import annotations

import asyncio
import selectors
import time
from collections.abc import Callable, Coroutine
from typing import Any

from textual._context import active_app
from textual.pilot import Pilot

_SOON = 0.02
"""Seconds: what a timer does so soon belongs to what is being done."""

_ROUNDS = 8
"""In one of so many rounds of a loop that has work it is asked whether something came for it."""

_LONGEST = 1.0
"""Seconds of processor time after which a loop counts as idle, though it goes on: what floods it
may do so for ever, and a machine with much else to do gives it little time."""

_SLOWEST = 5.0
"""How many times as many seconds of the clock may pass meanwhile."""

_SLICE = 0.1
"""Seconds after which it is looked whether the app has ended, whose screen then updates in vain."""

_PATIENCE = 60
"""Seconds until a test gives up; only a machine with much else to do needs more than one."""


class _Selector(selectors.DefaultSelector):
    """Calls back around each sleep of the loop, which sleeps when no task can go on."""

    def __init__(self) -> None:
        super().__init__()
        self.before_sleep: list[Callable[[], object]] = []
        self.after_sleep: list[Callable[[], object]] = []
        self._rounds = 0

    def select(self, timeout: float | None = None) -> list[tuple[selectors.SelectorKey, int]]:
        if timeout == 0:
            # Most rounds are those of a loop with work, and each question is a call of the system.
            self._rounds += 1
            return super().select(0) if self._rounds % _ROUNDS == 0 else []
        if timeout is not None and timeout <= (_SOON if self.before_sleep else 0):
            return super().select(timeout)
        if not self.before_sleep:
            return self._sleep(timeout)
        events = super().select(0)
        if not events:
            self.before_sleep = _call(self.before_sleep)
        return events

    def _sleep(self, timeout: float | None) -> list[tuple[selectors.SelectorKey, int]]:
        events = super().select(timeout)
        self.after_sleep = _call(self.after_sleep)
        return events


def _has_ended() -> bool:
    app = active_app.get(None)
    return app is not None and app._exit


def _call(calls: list[Callable[[], object]]) -> list[Callable[[], object]]:
    for call in calls:
        call()
    return []


class IdleLoop(asyncio.SelectorEventLoop):
    """Tells when its tasks wait for a key, for another thread, or for a timer of some length."""

    def __init__(self) -> None:
        self._watched = _Selector()
        super().__init__(self._watched)

    async def idle(self, longest: float = _LONGEST) -> None:
        """Wait until no task can go on, or has worked for so many seconds."""
        end = time.thread_time() + longest
        for _ in range(int(longest * _SLOWEST / _SLICE)):
            is_idle = await self._told(self._watched.before_sleep, _SLICE)
            if is_idle or _has_ended() or time.thread_time() > end:
                return

    async def moved(self, longest: float) -> None:
        """Wait until the loop has something to do again, so many seconds at most."""
        await self._told(self._watched.after_sleep, longest)

    async def _told(self, calls: list[Callable[[], object]], longest: float) -> bool:
        """Wait for a call that is added to these, and tell whether it came in time, in seconds."""
        told = asyncio.Event()
        calls.append(told.set)
        try:
            await asyncio.wait_for(told.wait(), longest)
        except asyncio.TimeoutError:
            return False
        return True


def idle_loop() -> IdleLoop:
    """Return the loop that runs."""
    loop = asyncio.get_running_loop()
    assert isinstance(loop, IdleLoop)
    return loop


def run(coroutine: Coroutine[Any, Any, None]) -> None:
    """Run a coroutine in a loop of its own."""
    loop = IdleLoop()
    try:
        loop.run_until_complete(coroutine)
        loop.run_until_complete(loop.shutdown_asyncgens())
    finally:
        loop.close()


async def wait_for_idle(min_sleep: float = 0.0, max_sleep: float = _LONGEST) -> None:
    """Wait as Textual's function of this name does, but not for a fiftieth of a second at least."""
    await idle_loop().idle(max_sleep)


async def wait_for_screen(pilot: Pilot[Any], timeout: float = 30.0) -> bool:
    """Wait as Textual's pilot does, without a question to each widget of the screen."""
    await wait_for_idle()
    return pilot.app._exception is None


async def until(pilot: Pilot[Any], condition: Callable[[], object]) -> None:
    """Wait until something is the case, in the app or outside of it."""
    end = time.monotonic() + _PATIENCE
    await pilot.pause()
    while not condition():
        assert time.monotonic() < end, f"it did not happen within {_PATIENCE} seconds"
        # What happens outside of the app, to a file say, moves nothing in it.
        await idle_loop().moved(0.05)
        await pilot.pause()
