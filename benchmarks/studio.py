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
from collections.abc import Iterator
from pathlib import Path
from statistics import median, quantiles
from tempfile import TemporaryDirectory
from time import perf_counter

from textual import events
from textual.geometry import Region
from textual.pilot import Pilot
from textual.strip import Strip

from plastron_tui.studio.app import StudioApp
from plastron_tui.studio.screens.main import MainScreen

from .editor import key_name
from .programs import program
from .row import Row
from .start import start_rows

_STATEMENTS = 10_000
_SIZE = (200, 50)
_TYPED = "node500 publish text500 to 'chatter' of message_type String"
_KEYS_A_SECOND = 15
_SECONDS = 10
_WORDS = 12


class _Studio:
    """A studio that runs, and when things happened in it."""

    def __init__(self, pilot: Pilot[None], main: MainScreen) -> None:
        self.pilot = pilot
        self.main = main
        self.drawn = 0.0
        draw = main.editor.view.render_lines

        def render_lines(crop: Region) -> list[Strip]:
            strips = draw(crop)
            self.drawn = perf_counter()
            return strips

        main.editor.view.render_lines = render_lines  # type: ignore[method-assign]

    def press(self, character: str) -> float:
        """Let a key come, and return when it came."""
        start = perf_counter()
        self.pilot.app.post_message(events.Key(key_name(character), character))
        return start

    @property
    def is_current(self) -> bool:
        """Whether the diagnostics, the panels in sight and the preview are those of the text."""
        main = self.main
        analysis = main.open.analysis
        if analysis is None or analysis.text != main.open.text:
            return False
        wanted = main.wanted()
        return all(main.lists[name].entries is analysis.entries[name] for name in wanted.panels) and (
            wanted.preview is None or wanted.preview in analysis.previews
        )

    async def settled(self) -> float:
        """Wait until all is current, and return when it was."""
        while not self.is_current:
            await asyncio.sleep(0.001)
        await asyncio.sleep(0)
        return perf_counter()


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


async def _measure(file: Path) -> tuple[list[float], list[float], list[float]]:
    """Return the seconds of each key, of each pause of the loop, and after each last key."""
    keys: list[float] = []
    after: list[float] = []
    app = StudioApp(file)
    async with app.run_test(size=_SIZE) as pilot:
        main = app.main
        studio = _Studio(pilot, main)
        text = main.open.text
        main.editor.go_to(text.index(b"\n", len(text) // 2) + 1)
        await studio.settled()
        await pilot.pause(0.5)
        async with _Watch() as watch:
            start = perf_counter()
            for number in range(_KEYS_A_SECOND * _SECONDS):
                at = number % (len(_TYPED) + 1)
                pressed = studio.press((_TYPED + "\n")[at]) if at < len(_TYPED) else _enter(studio)
                while studio.drawn <= pressed:
                    await asyncio.sleep(0)
                keys.append(studio.drawn - pressed)
                rest = start + (number + 1) / _KEYS_A_SECOND - perf_counter()
                await asyncio.sleep(max(0, rest))
        await studio.settled()
        for number in range(_WORDS):
            for character in "ab":
                last = studio.press(character)
                await asyncio.sleep(1 / _KEYS_A_SECOND if character == "a" else 0)
            while studio.drawn <= last:
                await asyncio.sleep(0)
            after.append(await studio.settled() - last)
            await pilot.pause(0.2)
    main.analyst.join(5)
    return keys, watch.pauses, after


def _enter(studio: _Studio) -> float:
    start = perf_counter()
    studio.pilot.app.post_message(events.Key("enter", "\r"))
    return start


def rows() -> Iterator[Row]:
    with TemporaryDirectory() as folder:
        file = _prepare(Path(folder))
        keys, pauses, after = asyncio.run(_measure(file))
    yield Row("a key in the studio, 10,000 statements, median", median(keys) * 1e3, 16, "ms")
    yield Row(
        "a key in the studio, 10,000 statements, 95th percentile",
        quantiles(keys, n=20)[-1] * 1e3,
        33,
        "ms",
    )
    yield Row(
        "longest pause of the event loop, 15 keys a second for 10 s",
        max(pauses) * 1e3,
        50,
        "ms",
        f"99th percentile {quantiles(pauses, n=100)[-1] * 1e3:.0f} ms",
    )
    yield Row(
        "diagnostics, panels and preview after the last key, median",
        median(after) * 1e3,
        150,
        "ms",
        f"from {min(after) * 1e3:.0f} to {max(after) * 1e3:.0f} ms",
    )
    done = subprocess.run(
        [sys.executable, "-m", "benchmarks.studio"], capture_output=True, text=True, check=True
    )
    yield Row("peak memory of a studio in which is typed", float(done.stdout), 250, "MB")
    yield from start_rows()


def _prepare(folder: Path) -> Path:
    """Write the program; let what the studio remembers be in the folder too."""
    for name in ("XDG_CONFIG_HOME", "XDG_STATE_HOME"):
        os.environ[name] = str(folder)
    file = folder / "program.plastron"
    file.write_bytes(program(_STATEMENTS))
    return file


if __name__ == "__main__":
    with TemporaryDirectory() as own:
        asyncio.run(_measure(_prepare(Path(own))))
    print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024)
