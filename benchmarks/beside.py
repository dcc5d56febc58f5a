"""What goes to the terminal for a key, beside other programs of its kind.

Each program runs in a terminal of 120 columns and 40 rows that answers nothing, ours with all its
panels. A key comes when nothing has been written for a while; all counts that is written
before it is quiet again. Other programs are measured where they are on the PATH: posting and
harlequin, and an app that is a stock `TextArea` of Textual's with the same program in it. They are
nothing that Plastron depends on.
"""

from __future__ import annotations

import os
import shutil
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from math import inf
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory

from .pasting import lines, paste
from .row import Row
from .terminal import Terminal

_TEXT_AREA = """\
import sys
from pathlib import Path
from textual.app import App
from textual.widgets import TextArea


class Editor(App[None]):
    def compose(self):
        yield TextArea(Path(sys.argv[1]).read_text(), show_line_numbers=True)


Editor().run()
"""
_TYPED = b"message_type "
_MOVES = (b"\x1b[B", b"\x1b[A", b"\x1b[C", b"\x1b[D")
_TIMES = 4
_QUIET = 0.4
"""Seconds without output after which nothing more follows from a key."""
_BOUND = 1000
_EXAMPLE = Path(__file__).parent.parent / "examples" / "tour.plastron"


@dataclass(frozen=True)
class _Program:
    """A program to measure.

    Attributes:
        command: what starts it.
        ready: what it shows as soon as it can be used.
        before: keys that bring one to where text is typed.
        is_editor: whether it has lines of text.
    """

    name: str
    command: list[str]
    ready: bytes
    before: tuple[bytes, ...] = ()
    is_editor: bool = True


@dataclass(frozen=True)
class _Found:
    """What was measured: seconds, and bytes for each key."""

    start: float
    processor: float
    typed: list[int]
    moved: list[int]
    pasted: float | None

    def told(self, name: str) -> str:
        pasted = ""
        if self.pasted is not None:
            took = "no end of it" if self.pasted == inf else f"{self.pasted:.1f} s"
            pasted = f", 500 lines pasted: {took}"
        return (
            f"{name} {median(self.typed):.0f} and {median(self.moved):.0f} B, start "
            f"{self.start * 1e3:.0f} ms, {self.processor * 1e3:.0f} of a processor{pasted}"
        )


def _programs(home: Path) -> Iterator[_Program]:
    program, stock = home / "tour.plastron", home / "text_area.py"
    program.write_bytes(_EXAMPLE.read_bytes())
    stock.write_text(_TEXT_AREA)
    down = (b"\x1b[B",) * 5
    plastron = [sys.executable, "-m", "plastron_tui", str(program)]
    yield _Program("plastron", plastron, b"create_message", down)
    yield _Program("TextArea", [sys.executable, str(stock), str(program)], b"create_message", down)
    if harlequin := shutil.which("harlequin"):
        yield _Program("harlequin", [harlequin], b"Query Editor", (b"a", b"\r", b"b"))
    if posting := shutil.which("posting"):
        # Its address line; with an address that can be edited.
        yield _Program("posting", [posting], b"Collection", (b"\x0c", b"address"), is_editor=False)


def _measure(program: _Program, home: Path) -> _Found:
    terminal = Terminal(program.command, home)
    try:
        start = terminal.wait_for(program.ready)
        processor = terminal.processor_seconds()
        terminal.quiet(1.5)
        for key in program.before:
            terminal.answer(key, _QUIET)
        typed = [len(terminal.answer(bytes([key]), _QUIET)) for key in _TYPED]
        moves = _MOVES if program.is_editor else _MOVES[2:]
        moved = [len(terminal.answer(key, _QUIET)) for key in moves for _ in range(_TIMES)]
        return _Found(start, processor, typed, moved, _pasted(terminal, program))
    finally:
        terminal.close()


def _measured(program: _Program, home: Path) -> _Found | None:
    try:
        return _measure(program, home)
    except OSError:
        # Another program may end of itself, or not even start.
        if program.name == "plastron":
            raise
        print(f"{program.name} cannot be measured", file=sys.stderr)
        return None


def _pasted(terminal: Terminal, program: _Program) -> float | None:
    if not program.is_editor:
        return None
    try:
        return paste(terminal, lines("\r"))
    except TimeoutError:
        return inf


def rows() -> Iterator[Row]:
    with TemporaryDirectory() as folder:
        home = Path(folder)
        os.environ["HOME"] = folder
        measured = {program.name: _measured(program, home) for program in _programs(home)}
    found = {name: each for name, each in measured.items() if each is not None}
    ours = found.pop("plastron")
    others = "; ".join(each.told(name) for name, each in found.items())
    yield Row("bytes to the terminal for a character, median", median(ours.typed), _BOUND, "B")
    yield Row(
        "bytes to the terminal for a move of the cursor, median",
        median(ours.moved),
        _BOUND,
        "B",
        others,
    )
    if "TextArea" in found:
        ratio = ours.processor / found["TextArea"].processor
        name = "processor from start to a readable program / to a stock TextArea"
        yield Row(name, ratio, 3, detail=ours.told("plastron"))
