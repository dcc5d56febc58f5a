"""Reading the file of a program."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, LineIndex
from plastron_tui.output.own_files import settled
from plastron_tui.regular_files import read_named, read_regular, reason

LONGEST_LINE = 256 * 1024
"""The longest line of a program, in bytes; a statement has some eighty."""

LARGEST_PROGRAM = 16 * 1024 * 1024
"""The largest program that is read, in bytes: some 300,000 statements."""


class ProgramText(NamedTuple):
    """What a program file holds, or why it cannot be read; and warnings."""

    text: bytes | None
    diagnostics: tuple[Diagnostic, ...] = ()


def read_program(path: Path) -> ProgramText:
    """Read the text of a program; what is no text is a diagnostic.

    A write to its folder that was interrupted is finished before.
    """
    notes = settled(path.parent)
    try:
        text = read_named(path, LARGEST_PROGRAM)
    except (OSError, ValueError) as error:
        read = _unreadable(path, f"`{path.name or path}` cannot be read: {reason(error)}")
        return read._replace(diagnostics=(*read.diagnostics, *notes))
    read = check_text(path, text)
    return read._replace(diagnostics=(*read.diagnostics, *notes))


def lines_of(file: Path) -> LineIndex | None:
    """Return the lines of a file that a diagnostic is about, None where it cannot be read."""
    try:
        return LineIndex(read_regular(file, LARGEST_PROGRAM))
    except (OSError, ValueError):
        return None


def check_text(path: Path | None, text: bytes) -> ProgramText:
    """Check that bytes are the text of a program: UTF-8 in lines, without NUL bytes."""
    if len(text) > LARGEST_PROGRAM:
        return _unreadable(path, f"the program is larger than {LARGEST_PROGRAM // 1024**2} MB")
    if len(text) > LONGEST_LINE:
        for row, line in enumerate(text.split(b"\n"), 1):
            if len(line) > LONGEST_LINE:
                limit = LONGEST_LINE // 1024
                return _unreadable(path, f"line {row} is longer than {limit} kB")
    if b"\0" in text:
        return _unreadable(path, "the file has NUL bytes and is no text")
    try:
        text.decode("utf-8")
    except UnicodeDecodeError as error:
        row = text.count(b"\n", 0, error.start) + 1
        return _unreadable(
            path, f"the file is not UTF-8 (line {row})", "save it in the encoding UTF-8"
        )
    return ProgramText(text)


def _unreadable(path: Path | None, message: str, remedy: str | None = None) -> ProgramText:
    from plastron_tui.diagnostics import codes

    return ProgramText(None, (Diagnostic(codes.UNREADABLE_FILE, message, file=path, help=remedy),))
