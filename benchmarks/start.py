"""How soon the studio can be used, against the smallest app that Textual can run.

Both are started in a terminal of their own that answers nothing. The time goes from the start of
the process to the first output in which the text can be read.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory

from .programs import program
from .row import Row
from .terminal import Terminal

_HELLO = """\
from textual.app import App
from textual.widgets import Label


class Hello(App[None]):
    def compose(self):
        yield Label("hello world")


Hello().run()
"""
_RUNS = 15
_BIG = 10_000


def _seconds(
    command: list[str], home: Path, text: bytes, typed: bytes = b""
) -> tuple[float, float]:
    """Return when a text was readable, and when what was then typed was."""
    terminal = Terminal(command, home)
    try:
        readable = terminal.wait_for(text)
        if not typed:
            return readable, readable
        terminal.type(typed)
        return readable, terminal.wait_for(typed)
    finally:
        terminal.close()


def start_rows() -> Iterator[Row]:
    with TemporaryDirectory() as folder:
        home = Path(folder)
        (home / "hello.py").write_text(_HELLO)
        small, big = home / "small.plastron", home / "big.plastron"
        small.write_bytes(program(10))
        big.write_bytes(program(_BIG))
        hello = [sys.executable, str(home / "hello.py")]
        studio = [sys.executable, "-m", "plastron_tui"]
        found: list[tuple[float, float, float, float, float]] = []
        for _ in range(_RUNS + 1):
            least, _ = _seconds(hello, home, b"hello world")
            own, typed = _seconds([*studio, str(small)], home, b"create_message", b"Z")
            long, long_typed = _seconds([*studio, str(big)], home, b"create_message", b"Z")
            found.append((least, own, typed, long, long_typed))
        del found[0]
    least, own, typed, long, _ = (median(column) for column in zip(*found, strict=True))
    yield Row(
        "start to a readable program / to a Textual hello-world",
        median(row[1] / row[0] for row in found),
        1.5,
        detail=f"{own * 1e3:.0f} ms / {least * 1e3:.0f} ms",
    )
    yield Row(
        "start to the first key shown / to a Textual hello-world",
        median(row[2] / row[0] for row in found),
        1.5,
        detail=f"{typed * 1e3:.0f} ms / {least * 1e3:.0f} ms",
    )
    yield Row(
        "start with 10,000 statements to the first key shown, beyond ten",
        median(row[4] - row[2] for row in found),
        1,
        "s",
        f"{long * 1e3:.0f} ms to readable",
    )
