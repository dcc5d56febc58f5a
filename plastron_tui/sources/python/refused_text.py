"""Texts that Python refuses for sure, whichever version of it runs them."""

from __future__ import annotations

from pathlib import Path

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.sources.grammars import python_lines
from plastron_tui.sources.not_text import not_utf_8

from .compiling import syntax_error
from .syntax import declared_encoding, parse


def refusal(path: Path, text: bytes, ros_version: int = 2) -> Diagnostic | None:
    """Return why Python refuses a file, None where that is not sure.

    Python itself and the grammar have to agree: a newer Python may read what the one that runs
    this does not, and the grammar may miss something. What is for ROS 1 may be for Python 2.
    """
    found = None if declared_encoding(text) else not_utf_8(text, path)
    is_unreadable = found is not None and found.code is codes.UNREADABLE_FILE
    if not is_unreadable and (ros_version == 1 or not parse(text).errors):
        return None
    # What is imported may have comments in any encoding.
    wrong = syntax_error(text)
    if wrong is None or is_unreadable:
        return None if wrong is None else found
    reason = wrong.reason.removesuffix(f" (line {wrong.line})")
    span = Span(0, 0) if wrong.line is None else _line(text, wrong.line)
    return Diagnostic(codes.BROKEN_PYTHON, f"this is no Python 3: {reason}", span, path)


def _line(text: bytes, number: int) -> Span:
    """Return what a line says, its blanks left out."""
    lines = python_lines(text).split(b"\n")
    row = min(max(number, 1), len(lines)) - 1
    start = sum(map(len, lines[:row])) + row
    said = lines[row].strip()
    start += lines[row].find(said)
    return Span(start, start + len(said))
