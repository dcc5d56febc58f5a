"""Splices: what an edit replaces; every byte that no splice covers stays.

What holds for the files of every language: node files, manifests, build files.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

BYTE_ORDER_MARK = b"\xef\xbb\xbf"


@dataclass(frozen=True, slots=True, order=True)
class Splice:
    """Replace the bytes from `start` to `end` by `text`."""

    start: int
    end: int
    text: bytes = b""


def apply(text: bytes, splices: Iterable[Splice]) -> bytes:
    """Apply splices; deletions may overlap, and what is inserted at one place keeps its order."""
    parts: list[bytes] = []
    at = 0
    for splice in sorted(splices, key=lambda splice: (splice.start, splice.end)):
        start = max(splice.start, at)
        parts += (text[at:start], splice.text)
        at = max(splice.end, start)
    parts.append(text[at:])
    return b"".join(parts)


def line_start(text: bytes, offset: int) -> int:
    """Return where the line of an offset begins; a byte order mark is before the first line."""
    start = text.rfind(b"\n", 0, offset) + 1
    return 3 if start == 0 and text.startswith(BYTE_ORDER_MARK) else start


def line_end(text: bytes, offset: int) -> int:
    """Return where the line of an offset ends, its line ending included."""
    end = text.find(b"\n", offset)
    return len(text) if end < 0 else end + 1


def newline_of(text: bytes) -> bytes:
    """Return the line ending that a text has, that of its first line."""
    end = text.find(b"\n")
    return b"\r\n" if end > 0 and text[end - 1 : end] == b"\r" else b"\n"


def indent_of(text: bytes, offset: int) -> bytes:
    """Return the blanks that begin the line of an offset."""
    start = line_start(text, offset)
    line = text[start : line_end(text, start)]
    return line[: len(line) - len(line.lstrip(b" \t"))]


def line_number(text: bytes, offset: int) -> int:
    """Return the number of the line of an offset, from 1."""
    return text.count(b"\n", 0, offset) + 1
