"""How long a key takes in the editor, against Textual's own text area with the same grammar.

Both widgets are alone in an app of their own, hold the same program of 10,000 statements, and get
the same keys in its middle, a stretch in the one and a stretch in the other in turn. A key's time
goes from the event's being posted to the end of the last drawing of lines that follows from it.
"""

from __future__ import annotations

import asyncio
import resource
import subprocess
import sys
from collections.abc import Iterator
from contextlib import AsyncExitStack
from statistics import median, quantiles
from time import perf_counter
from typing import Any

import tree_sitter_plastron
from textual import events
from textual.app import App, ComposeResult
from textual.geometry import Region
from textual.pilot import Pilot
from textual.strip import Strip
from textual.widget import Widget
from textual.widgets import Label, TextArea

from plastron_tui import collector
from plastron_tui.language.grammar import LANGUAGE
from plastron_tui.session import Session
from plastron_tui.studio.editor import ProgramEditor

from .programs import program
from .row import Row, seconds

_STATEMENTS = 10_000
_SIZE = (120, 40)
_TYPED = "node500 publish text500 to 'chatter' of message_type String"
_STRETCH = 15
_ROUNDS = 4
_LONG_TEXT = b'"' + b"text, " * 16_660 + b'"\n'
_SLOW = "(.*,){20}x"
"""An expression that is given up, after a quarter of a second."""


class _Drawn:
    """When lines were drawn last."""

    at = 0.0


class _Stock(TextArea):
    def render_lines(self, crop: Region) -> list[Strip]:
        strips = super().render_lines(crop)
        _Drawn.at = perf_counter()
        return strips


class _App(App[None]):
    def __init__(self, widget: Widget) -> None:
        super().__init__()
        self.widget = widget

    def compose(self) -> ComposeResult:
        yield self.widget


def _ours(text: bytes) -> ProgramEditor:
    editor = ProgramEditor(Session(text, environ={}))
    draw = editor.view.render_lines

    def render_lines(crop: Region) -> list[Strip]:
        strips = draw(crop)
        _Drawn.at = perf_counter()
        return strips

    editor.view.render_lines = render_lines  # type: ignore[method-assign]
    return editor


def _stock(text: bytes) -> TextArea:
    area = _Stock(text.decode())
    area.register_language("plastron", LANGUAGE, tree_sitter_plastron.HIGHLIGHTS_QUERY)
    area.language = "plastron"
    return area


async def _key(pilot: Pilot[None], character: str) -> float:
    """Press a key; return the seconds until the lines were drawn."""
    start = await _press(pilot, character)
    await pilot.pause()
    return _Drawn.at - start


async def _press(pilot: Pilot[None], character: str) -> float:
    """Press a key, and wait until lines are drawn; return when it was pressed."""
    start = perf_counter()
    pilot.app.post_message(events.Key(key_name(character), character))
    while _Drawn.at <= start:
        await asyncio.sleep(0)
    return start


def key_name(character: str) -> str:
    names = {" ": "space", "'": "apostrophe", "_": "underscore"}
    return names.get(character, character)


def _with_empty_line() -> tuple[bytes, int]:
    """Return a program with an empty line in its middle, and where that is."""
    text = program(_STATEMENTS)
    middle = text.index(b"\n", len(text) // 2) + 1
    return text[:middle] + b"\n" + text[middle:], middle


async def _measure() -> tuple[list[float], list[float]]:
    text, middle = _with_empty_line()
    ours: list[float] = []
    stock: list[float] = []
    async with AsyncExitStack() as stack:
        editor, area = _ours(text), _stock(text)
        pilots = [
            await stack.enter_async_context(_App(widget).run_test(size=_SIZE))
            for widget in (editor, area)
        ]
        editor.focus()
        editor.set_diagnostics(editor.session.diagnostics)
        editor.go_to(middle)
        area.focus()
        area.move_cursor((text.count(b"\n", 0, middle), 0))
        for pilot in pilots:
            await pilot.pause(0.2)
        for round_ in range(_ROUNDS):
            typed = _TYPED[round_ * _STRETCH : (round_ + 1) * _STRETCH]
            for pilot, times in zip(pilots, (ours, stock), strict=True):
                for character in typed:
                    await pilot.pause()
                    times.append(await _key(pilot, character))
    return ours, stock


async def _measure_long(is_searching: bool) -> list[float]:
    """Type within a line of 100,000 characters, wrapped, perhaps while an expression is sought."""
    editor = _ours(b"create_message text of message_type String and input " + _LONG_TEXT)
    editor.view.soft_wrap = True
    times = []
    async with _App(editor).run_test(size=_SIZE) as pilot:
        editor.focus()
        editor.go_to(len(_LONG_TEXT) // 2)
        for character in _TYPED[: 2 * _STRETCH]:
            await pilot.pause()
            if is_searching:
                editor.finder.find(_SLOW, is_regex=True, is_case_sensitive=True)
            # What is found later is drawn later, and is no part of the key.
            start = await _press(pilot, character)
            times.append(_Drawn.at - start)
    return times


def rows() -> Iterator[Row]:
    line = "a key in a line of 100,000 characters"
    for is_searching, what, bound in ((False, "", 33), (True, ", a slow expression sought", 50)):
        times = asyncio.run(_measure_long(is_searching))
        yield Row(f"{line}{what}, median", median(times) * 1e3, bound, "ms")
    ours, stock = asyncio.run(_measure())
    here, there = median(ours), median(stock)
    yield Row(
        "a key in the middle of 10,000 statements, median",
        here * 1e3,
        16,
        "ms",
        f"the text area: {there * 1e3:.0f} ms",
    )
    yield Row(
        "a key in the middle of 10,000 statements, 95th percentile",
        quantiles(ours, n=20)[-1] * 1e3,
        33,
        "ms",
        f"the text area: {quantiles(stock, n=20)[-1] * 1e3:.0f} ms",
    )
    yield Row("a key in the editor / in the text area, medians", here / there, 1 / 20)
    opened = median(seconds(lambda: asyncio.run(_open())) for _ in range(5))
    empty = median(seconds(lambda: asyncio.run(_open_label())) for _ in range(5))
    yield Row("opening 10,000 statements, beyond an app with a label", opened - empty, 1, "s")
    done = subprocess.run(
        [sys.executable, "-m", "benchmarks.editor"], capture_output=True, text=True, check=True
    )
    yield Row("peak memory while 10,000 statements are edited", float(done.stdout), 250, "MB")


async def _open() -> None:
    app: Any = _App(ProgramEditor(Session(program(_STATEMENTS), environ={})))
    async with app.run_test(size=_SIZE):
        pass


async def _open_label() -> None:
    app: Any = _App(Label("hello"))
    async with app.run_test(size=_SIZE):
        pass


async def _edit() -> None:
    text, middle = _with_empty_line()
    editor = _ours(text)
    async with _App(editor).run_test(size=_SIZE) as pilot:
        editor.focus()
        editor.go_to(middle)
        for character in _TYPED * 4:
            await _key(pilot, character)
            editor.set_diagnostics(editor.session.diagnostics)


if __name__ == "__main__":
    collector.look_seldom()
    asyncio.run(_edit())
    print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024)
