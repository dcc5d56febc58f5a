"""The studio as a whole: keys, what follows from them, and its start.

A program of 10,000 statements is open in a window that has room for all panels. Keys come as from
a fast writer, in the middle of the program; the event loop is watched by a task that wants to run
every millisecond.
"""

from __future__ import annotations

import asyncio
import os
import resource
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from statistics import median, quantiles
from tempfile import TemporaryDirectory
from time import perf_counter, process_time
from typing import NamedTuple

from textual import events
from textual.geometry import Region
from textual.pilot import Pilot
from textual.strip import Strip

from plastron_tui import collector
from plastron_tui.diagnostics import Span
from plastron_tui.language.grammar import new_parser
from plastron_tui.studio.app import StudioApp
from plastron_tui.studio.main.screen import MainScreen

from .editor import key_name
from .programs import program
from .row import Row, seconds
from .start import start_rows

_STATEMENTS = 10_000
_SIZE = (200, 50)
_TYPED = "node500 publish text500 to 'chatter' of message_type String\n"
_KEYS_A_SECOND = 15
_SECONDS = 10
_WORDS = 12


class _Studio:
    """A studio that runs, and when things happened in it."""

    def __init__(self, pilot: Pilot[None], main: MainScreen) -> None:
        self.pilot = pilot
        self.main = main
        self.drawn = 0.0
        self.drawn_text = b""
        draw = main.editor.view.render_lines

        def render_lines(crop: Region) -> list[Strip]:
            strips = draw(crop)
            self.drawn, self.drawn_text = perf_counter(), main.open.text
            return strips

        main.editor.view.render_lines = render_lines  # type: ignore[method-assign]

    async def press(self, character: str) -> float:
        """Let a key come, wait until what it types is drawn, and return the seconds that took."""
        before, start = self.main.open.text, perf_counter()
        name, text = ("enter", "\r") if character == "\n" else (key_name(character), character)
        self.pilot.app.post_message(events.Key(name, text))
        while self.drawn <= start or self.drawn_text is before:
            await asyncio.sleep(0)
        return self.drawn - start

    @property
    def is_current(self) -> bool:
        """Whether the diagnostics, the panels in sight and the preview are those of the text."""
        main = self.main
        analysis = main.open.analysis
        if analysis is None or analysis.text != main.open.text:
            return False
        return all(request in analysis.made for request in main.feed.wanted())

    async def settled(self) -> None:
        """Wait until all is current."""
        while not self.is_current:
            # More often would be to disturb the worker, which is what is measured.
            await asyncio.sleep(0.004)
        await asyncio.sleep(0)


class _Times(NamedTuple):
    """What was measured, in seconds."""

    keys: list[float]
    pauses: list[float]
    after: list[float]
    processor: list[float]


class _Watch:
    """Measures for how long the event loop does not come round."""

    def __init__(self) -> None:
        self.pauses: list[float] = []
        self._task: asyncio.Task[None] | None = None

    async def __aenter__(self) -> _Watch:
        self._task = asyncio.create_task(self._run())
        return self

    async def __aexit__(self, *_: object) -> None:
        assert self._task is not None
        self._task.cancel()

    async def _run(self) -> None:
        while True:
            start = perf_counter()
            await asyncio.sleep(0.001)
            self.pauses.append(perf_counter() - start - 0.001)


async def measure(file: Path, ready: Callable[[], object] = lambda: None) -> _Times:
    """Type for a while, then word by word; call `ready` before."""
    app = StudioApp(file)
    async with app.run_test(size=_SIZE) as pilot:
        main = app.main
        studio = _Studio(pilot, main)
        text = main.open.text
        middle = text.index(b"\n", len(text) // 2) + 1
        main.editor.replace(Span(middle, middle), "\n")
        main.editor.go_to(middle)
        await studio.settled()
        await pilot.pause(0.5)
        ready()
        async with _Watch() as watch:
            keys = await _type(studio)
        await studio.settled()
        after, processor = [], []
        for _ in range(_WORDS):
            await studio.press("a")
            await asyncio.sleep(1 / _KEYS_A_SECOND)
            used, last = process_time(), perf_counter()
            await studio.press("b")
            await studio.settled()
            after.append(perf_counter() - last)
            processor.append(process_time() - used)
            await pilot.pause(0.5)
    main.feed.worker.join(5)
    return _Times(keys, watch.pauses, after, processor)


async def _type(studio: _Studio) -> list[float]:
    """Type at a writer's pace, and return how long each key took."""
    keys = []
    start = perf_counter()
    for number in range(_KEYS_A_SECOND * _SECONDS):
        keys.append(await studio.press(_TYPED[number % len(_TYPED)]))
        rest = start + (number + 1) / _KEYS_A_SECOND - perf_counter()
        await asyncio.sleep(max(0, rest))
    return keys


def rows() -> Iterator[Row]:
    with TemporaryDirectory() as folder:
        file = prepare(Path(folder))
        times = asyncio.run(measure(file))
    yield Row("a key in the studio, median", median(times.keys) * 1e3, 16, "ms")
    yield Row(
        "a key in the studio, 95th percentile", quantiles(times.keys, n=20)[-1] * 1e3, 33, "ms"
    )
    yield Row(
        f"longest pause of the studio, {_KEYS_A_SECOND} keys a second for {_SECONDS} s",
        max(times.pauses) * 1e3,
        50,
        "ms",
        f"99 of 100 take less than {quantiles(times.pauses, n=100)[-1] * 1e3:.0f} ms",
    )
    parser, text = new_parser(), program(_STATEMENTS)
    parse = median(seconds(lambda: parser.parse(text)) for _ in range(9))
    yield Row(
        "diagnostics, panels and preview after the last key, median",
        median(times.after) * 1e3,
        150,
        "ms",
        f"from {min(times.after) * 1e3:.0f} to {max(times.after) * 1e3:.0f} ms; "
        f"{median(times.processor) * 1e3:.0f} ms of a processor; bare parse {parse * 1e3:.0f} ms",
    )
    done = subprocess.run(
        [sys.executable, "-m", "benchmarks.studio"], capture_output=True, text=True, check=True
    )
    yield Row("peak memory of a studio in which one types", float(done.stdout), 250, "MB")
    yield from start_rows()


def prepare(folder: Path) -> Path:
    """Write the program; let what the studio remembers be in the folder too."""
    for name in ("XDG_CONFIG_HOME", "XDG_STATE_HOME"):
        os.environ[name] = str(folder)
    file = folder / "program.plastron"
    file.write_bytes(program(_STATEMENTS))
    return file


if __name__ == "__main__":
    collector.look_seldom()
    with TemporaryDirectory() as own:
        asyncio.run(measure(prepare(Path(own))))
    print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024)
