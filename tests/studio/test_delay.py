"""What is done a while after it was asked for."""

from __future__ import annotations

import asyncio
import time

import pytest
from idle_loop import until
from textual.app import App

from plastron_tui.studio.delay import Delay

SOON = 0.001


async def test_it_is_done_once_however_late_and_only_for_the_last_time_it_was_asked() -> None:
    app: App[None] = App()
    async with app.run_test() as pilot:
        done: list[int] = []
        delay = Delay(app, lambda: done.append(len(done)))
        for wanted in range(3):
            delay.start(60.0)
            delay.start(SOON)
            time.sleep(20 * SOON)
            assert delay.is_waiting
            await until(pilot, lambda: not delay.is_waiting)
            assert done == list(range(wanted + 1))


@pytest.mark.parametrize("is_on_its_way", [False, True])
async def test_what_was_stopped_is_not_done(is_on_its_way: bool) -> None:
    app: App[None] = App()
    async with app.run_test() as pilot:
        done: list[int] = []
        delay = Delay(app, lambda: done.append(1))
        delay.start(0.0)
        if is_on_its_way:
            time.sleep(SOON)
            await asyncio.sleep(0)
        delay.stop()
        after = Delay(app, lambda: done.append(2))
        after.start(SOON)
        await until(pilot, lambda: not after.is_waiting)
        assert done == [2]


async def test_it_is_done_in_the_widget_s_own_order_and_may_be_awaited() -> None:
    app: App[None] = App()
    async with app.run_test() as pilot:
        done: list[str] = []

        async def do() -> None:
            await asyncio.sleep(0)
            done.append("done")

        Delay(app, do).start(0.0)
        await until(pilot, lambda: done)
        assert done == ["done"]
