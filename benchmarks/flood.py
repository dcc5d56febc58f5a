"""What the studio does at a turn of what a node prints as fast as it can: keys wait for that."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable, Iterator
from statistics import median

from plastron_tui.runtime.process_lines import Backlog
from plastron_tui.studio import running
from plastron_tui.studio.app import StudioApp
from plastron_tui.studio.panels.output import OutputPanel
from plastron_tui.studio.panels.output_log import MOST_RECORDS

from .row import Row

_FRAME = 1000 / 60
_TURNS = 60
_LINES: dict[str, Callable[[int], str]] = {
    "lines": lambda number: f"talker | {number} {'x' * 70}",
    "long lines": lambda number: f"talker | {number} {'word ' * 700}",
    "short lines": lambda number: f"talker | {number}",
}


def rows() -> Iterator[Row]:
    for name, line in _LINES.items():
        turns = asyncio.run(_turns(line))
        yield Row(
            f"Output takes a turn of {name} that flood it", median(turns), _FRAME, "ms",
            detail=f"{max(turns):.1f} at most",
        )  # fmt: skip


async def _turns(line: Callable[[int], str]) -> list[float]:
    """Return how long turns take, in milliseconds of the processor, once all is kept that can be.

    What is shown is drawn between them, and not counted.
    """
    app, number, found = StudioApp(), 0, []
    async with app.run_test(size=(120, 40)) as pilot:
        output = app.main.panels["output"]
        assert isinstance(output, OutputPanel)
        app.main.dock_layout.reveal("output")
        await pilot.pause()
        output.add(f"talker | {number}" for number in range(MOST_RECORDS))
        for _ in range(_TURNS):
            waiting = Backlog(
                most_lines=MOST_RECORDS,
                most_bytes=running.MOST_WAITING,
                at_once=running.AT_ONCE,
                is_kept=lambda _: False,
            )
            for _ in range(MOST_RECORDS):
                waiting.add(line(number).encode())
                number += 1
            start = time.process_time()
            output.add(each.decode() for each in waiting.take())
            found.append((time.process_time() - start) * 1000)
            await pilot.pause()
    return found
