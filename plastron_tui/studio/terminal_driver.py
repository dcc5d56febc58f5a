"""The studio's line to a terminal: what is written is kept short, what comes at once stays so."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from time import monotonic
from typing import IO, TYPE_CHECKING, Any, cast

from textual import events
from textual.constants import ESCAPE_DELAY
from textual.driver import Driver
from textual.message import Message

from .bracketed_paste import ESCAPE, PasteBrackets
from .key_bursts import Bursts, Kind, Part
from .terminal_output import ShownScreen
from .textual_private import (
    linux_driver,
    output_of,
    parse_input_with,
    take_any_bytes,
    write_where_it_is_seen,
)

if TYPE_CHECKING:
    from textual._xterm_parser import XTermParser


class Burst(events.Event):
    """A text that came as keys.

    Attributes:
        text: the text; a line ends in CR or LF.
        keys: the keys.
    """

    def __init__(self, text: str, keys: list[events.Key]) -> None:
        super().__init__()
        self.text = text
        self.keys = keys


def for_terminal(
    driver: type[Driver], shown: ShownScreen, failed: Callable[[Exception], object]
) -> type[Driver]:
    """Return a driver for the studio that does all that another one does; a browser's as it is.

    Args:
        driver: Textual's choice.
        shown: what the terminal shows; it is told of what is written, and has to be told of else.
        failed: takes what ended the thread that reads from the terminal, in that thread.
    """
    base = linux_driver()
    if base is None or driver is not base:
        return driver
    parse_input_with(_with_bursts)
    take_any_bytes()

    class StudioDriver(driver):  # type: ignore[valid-type, misc]
        """Writes to the terminal only what differs from what it shows."""

        def __init__(self, *args: Any, **keywords: Any) -> None:
            super().__init__(*args, **keywords)
            write_where_it_is_seen(self)

        def write(self, data: str) -> None:
            """Write what is not shown yet."""
            changes = shown.changes(data, _size(output_of(self)))
            if changes:
                super().write(changes)

        def run_input_thread(self) -> None:
            """Read from the terminal until the studio ends."""
            try:
                super().run_input_thread()
            except Exception as error:
                failed(error)

    return StudioDriver


def _size(file: IO[str] | None) -> tuple[int, int] | None:
    """Return the columns and rows of a terminal; None if it is none."""
    if file is None:
        return None
    try:
        size = os.get_terminal_size(file.fileno())
    except (OSError, ValueError):
        return None
    return size.columns, size.lines


def _with_bursts(parser: type[XTermParser]) -> type[XTermParser]:
    """Return a parser of what a terminal sends that tells bursts of text from keys."""

    class BurstParser(parser):  # type: ignore[valid-type, misc]
        """Hands a text that comes at once on as one event."""

        def __init__(self, debug: bool = False) -> None:
            super().__init__(debug)
            self._brackets = PasteBrackets(ESCAPE_DELAY)
            self._bursts = Bursts()

        def feed(self, data: str) -> Iterable[Message]:
            """Take what was read; "" at the end."""
            if not data:
                yield from super().feed(data)
                return
            now = monotonic()
            yield from self._taken(self._brackets.parts(data, now), now)

        def tick(self) -> Iterable[Message]:
            """Take note that time goes by."""
            yield from super().tick()
            now = monotonic()
            yield from self._taken(self._brackets.waited(now), now)

        def _taken(self, parts: Iterable[Part], now: float) -> Iterable[Message]:
            for part in parts:
                if part.kind is Kind.PASTE:
                    yield events.Paste(part.text)
                elif part.text == ESCAPE:
                    # Nothing follows; Textual would wait for it as long again.
                    yield events.Key("escape", ESCAPE)
                else:
                    yield from self._typed(part.text, now)

        def _typed(self, data: str, now: float) -> Iterable[Message]:
            for part in self._bursts.parts(data, now):
                match part.kind:
                    case Kind.KEYS:
                        yield from super().feed(part.text)
                    case Kind.BURST:
                        keys = cast("list[events.Key]", list(super().feed(part.text)))
                        yield Burst(part.text, keys)
                    case Kind.PASTE:
                        yield events.Paste(part.text)

    return BurstParser
