"""How far a build is, on a terminal in one line that is drawn over, else in a few lines."""

from __future__ import annotations

import shutil
from typing import TextIO

from plastron_tui.diagnostics.terminal import visible, width

from .build_output import Progress

_EACH = 25
"""By how many per cent a build that is told in lines has to be farther for the next line."""


class ProgressLine:
    """Shows how far a build is; a context, which leaves the cursor in a line of its own."""

    def __init__(self, stream: TextIO, why: str = "") -> None:
        """Prepare to show something.

        Args:
            stream: where it is written.
            why: why something is built, in a line of its own before the first; "" for none.
        """
        self._stream = stream
        self._why = why
        self._is_terminal = stream.isatty()
        self._told: tuple[str, str, int] | None = None
        self._width = 0

    def __enter__(self) -> ProgressLine:
        return self

    def __exit__(self, *_: object) -> None:
        if self._width:
            self._write(f"\r{' ' * self._width}\r")
            self._width = 0

    def tell(self, now: Progress) -> None:
        """Show how far a build is."""
        if self._why:
            self._write(f"{self._why}\n")
            self._why = ""
        if self._is_terminal:
            text = _words(now)[: max(shutil.get_terminal_size().columns - 1, 1)]
            self._write(f"\r{text}{' ' * (self._width - width(text))}")
            self._width = width(text)
            return
        told = (now.package, now.step, (now.percent or 0) // _EACH)
        if told != self._told:
            self._told = told
            self._write(f"{_words(now)}\n")

    def _write(self, text: str) -> None:
        self._stream.write(text)
        self._stream.flush()


def _words(now: Progress) -> str:
    percent = "" if now.percent is None else f", {now.percent} %"
    return visible(f"building `{now.package}`: {now.step}{percent}")
