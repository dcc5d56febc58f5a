"""From byte offsets to lines and columns."""

from __future__ import annotations

from bisect import bisect_right
from typing import NamedTuple

_BYTE_ORDER_MARK = b"\xef\xbb\xbf"


class Position(NamedTuple):
    """A place in a text: line and column count from 1, the column in characters."""

    line: int
    column: int


class LineIndex:
    """The line starts of a text, so that many offsets can be resolved cheaply.

    A byte order mark is before the first line: no editor shows or counts it.
    """

    def __init__(self, text: bytes) -> None:
        self._text = text
        starts = [len(_BYTE_ORDER_MARK) if text.startswith(_BYTE_ORDER_MARK) else 0]
        find = text.find
        at = find(b"\n")
        while at >= 0:
            starts.append(at + 1)
            at = find(b"\n", at + 1)
        self._starts = starts

    def __len__(self) -> int:
        return len(self._starts)

    def line_at(self, offset: int) -> int:
        """Return the number of the line of a byte offset, from 1; however long the line is."""
        return max(1, bisect_right(self._starts, min(offset, len(self._text))))

    def position(self, offset: int) -> Position:
        """Resolve a byte offset; one beyond the end counts as the end."""
        offset = min(max(offset, 0), len(self._text))
        row = self.line_at(offset) - 1
        before = self._text[self._starts[row] : offset]
        return Position(row + 1, len(before.decode("utf-8", "replace")) + 1)

    def line(self, number: int) -> str:
        """Return the text of a line, counted from 1, without its line ending."""
        start = self._starts[number - 1]
        end = self._starts[number] if number < len(self._starts) else len(self._text)
        return self._text[start:end].decode("utf-8", "replace").rstrip("\r\n")
