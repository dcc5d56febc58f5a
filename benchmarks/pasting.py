"""Pasting into the editor, from a terminal that puts no brackets around what it pastes."""

from __future__ import annotations

import os
import select
import sys
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter

from .row import Row
from .terminal import Terminal

_LINES = 500
_LAST = "zzlastzz"
_LONGEST = 30.0


def lines(end: str) -> bytes:
    """Return the lines that are pasted, and a last word."""
    line = "node{0} publish text{0} to 'chatter{0}' of message_type String"
    return (end.join(line.format(number) for number in range(_LINES)) + end + _LAST).encode()


def paste(terminal: Terminal, text: bytes) -> float:
    """Send a text as fast as the program takes it; return the seconds until its end is shown.

    Raises:
        TimeoutError: where that takes longer than half a minute.
    """
    terminal.output = b""
    start, sent = perf_counter(), 0
    os.set_blocking(terminal.file, False)
    while _LAST.encode() not in terminal.output:
        if perf_counter() - start > _LONGEST:
            raise TimeoutError(text[-40:])
        writing = [terminal.file] if sent < len(text) else []
        ready, free, _ = select.select([terminal.file], writing, [], 1)
        if free:
            try:
                sent += os.write(terminal.file, text[sent : sent + 4096])
            except BlockingIOError:
                continue
        if ready:
            terminal.output += os.read(terminal.file, 1 << 16)
    return perf_counter() - start


def rows() -> Iterator[Row]:
    for name, end in (("CR", "\r"), ("LF", "\n"), ("CR LF", "\r\n")):
        with TemporaryDirectory() as folder:
            file = Path(folder) / "pasted.plastron"
            terminal = Terminal([sys.executable, "-m", "plastron_tui", str(file)], Path(folder))
            try:
                terminal.wait_for(b"Quit")
                terminal.quiet(1)
                seconds = paste(terminal, lines(end))
                terminal.quiet(1)
                terminal.type(b"\x13")
                terminal.wait_for(b"saved")
            finally:
                terminal.close()
            lost = _LINES - file.read_bytes().count(b"\n")
        yield Row(f"{_LINES} lines pasted without brackets, {name}", seconds, 2, "s")
        yield Row(f"ends of lines lost of {_LINES}, {name}", abs(lost), 0, "")
