"""A line as it is shown: from bytes to terminal cells, and back.

The document counts bytes, a screen counts cells, and a cursor stands between characters as a
reader sees them. This is the one place where they are converted.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterator
from functools import lru_cache
from itertools import accumulate
from typing import NamedTuple

from rich.cells import cell_len, split_graphemes

TAB_WIDTH = 4
TAB = "→"
_CONTROL_PICTURES = 0x2400
_INVISIBLE = "�"
_JOINING = dict.fromkeys((0x200D, 0xFE0E, 0xFE0F))
"""Terminals do not agree on how wide the characters are that these join or change: they are
left out of what is shown, and the cells are right everywhere."""


class _Looks(NamedTuple):
    """What is shown of a character, how many cells that takes, and how many bytes it has."""

    shown: str
    cells: int
    size: int

    @classmethod
    def of(cls, cluster: str, cell: int = 0) -> _Looks:
        """Return how a character looks in a cell."""
        shown = _shown(cluster, cell)
        return cls(shown, cell_len(shown), len(cluster.encode("utf-8", "replace")))


class Line:
    """A line of a text, without its line ending.

    Attributes:
        shown: what stands on the screen: tabs spread out, control characters made visible.
        size: the length in bytes.
        width: the width in cells.
        tabs: the byte columns of the tabs.
    """

    __slots__ = ("_bytes", "_cells", "_chars", "shown", "size", "tabs", "width")

    def __init__(self, line: bytes) -> None:
        self.size = len(line)
        text = line.decode("utf-8", "replace")
        self._bytes: list[int] | None = None
        self.tabs: list[int] = []
        if len(text) == len(line) and text.isprintable():
            self.shown = text
            self.width = len(text)
            return
        self._lay_out(text)

    def _lay_out(self, text: str) -> None:
        """Note for each character where it starts in bytes, in cells, and in what is shown."""
        clusters = list(_clusters(text))
        # A long line has few characters that differ; how a tab looks depends on its place.
        known = {each: _Looks.of(each) for each in set(clusters)}
        looks = [known[each] for each in clusters]
        if "\t" in known:
            at_cell = 0
            for at, each in enumerate(looks):
                if clusters[at] == "\t":
                    looks[at] = each = _Looks.of("\t", at_cell)
                at_cell += each.cells
        stops_bytes = [*accumulate((each.size for each in looks), initial=0)]
        stops_cells = [*accumulate((each.cells for each in looks), initial=0)]
        stops_chars = [*accumulate((len(each.shown) for each in looks), initial=0)]
        if "\t" in known:
            self.tabs = [stops_bytes[at] for at, each in enumerate(clusters) if each == "\t"]
        self._bytes, self._cells, self._chars = stops_bytes, stops_cells, stops_chars
        self.shown = "".join([each.shown for each in looks])
        self.width = stops_cells[-1]

    def cell(self, column: int) -> int:
        """Return the cell at which the character of a byte column starts."""
        if self._bytes is None:
            return min(column, self.width)
        return self._cells[bisect_right(self._bytes, column) - 1]

    def column(self, cell: int) -> int:
        """Return the byte column of the character in a cell; the line's end beyond it."""
        if self._bytes is None:
            return min(max(cell, 0), self.size)
        return self._bytes[max(0, bisect_right(self._cells, cell) - 1)]

    def piece(self, start: int, end: int) -> str:
        """Return what is shown for the bytes of a line from one column to another."""
        if self._bytes is None:
            return self.shown[start:end]
        first = bisect_right(self._bytes, start) - 1
        last = bisect_left(self._bytes, end)
        last = min(last, len(self._bytes) - 1)
        return self.shown[self._chars[first] : self._chars[last]]

    def last_space(self, start: int, end: int) -> int | None:
        """Return the byte column of the last space between two columns, None where there is none.

        It is looked for at once where each byte is a character, as it is in most long lines.
        """
        if self._bytes is None:
            at = self.shown.rfind(" ", start, end)
            return at if at >= 0 else None
        at = end
        while at > start:
            before = self.previous_stop(at)
            if self.piece(before, at) == " ":
                return before
            at = before
        return None

    def next_stop(self, column: int) -> int:
        """Return the byte column after the character at a column."""
        if self._bytes is None:
            return min(column + 1, self.size)
        at = bisect_right(self._bytes, column)
        return self._bytes[min(at, len(self._bytes) - 1)]

    def previous_stop(self, column: int) -> int:
        """Return the byte column of the character before a column."""
        if self._bytes is None:
            return max(column - 1, 0)
        return self._bytes[max(0, bisect_left(self._bytes, column) - 1)]


def _clusters(text: str) -> Iterator[str]:
    """Yield the characters as a reader sees them; a control character is one of its own."""
    start = 0
    for at, character in enumerate(text):
        if character < " " or "\x7f" <= character <= "\x9f":
            yield from _graphemes(text[start:at])
            yield character
            start = at + 1
    yield from _graphemes(text[start:])


def _graphemes(text: str) -> Iterator[str]:
    if text.isascii():
        yield from text
    else:
        for start, end, _ in split_graphemes(text)[0]:
            yield text[start:end]


def _shown(cluster: str, cell: int) -> str:
    if cluster == "\t":
        return TAB + " " * (TAB_WIDTH - cell % TAB_WIDTH - 1)
    if not cluster.isascii():
        cluster = cluster.translate(_JOINING)
    if cluster.isprintable():
        return cluster if cell_len(cluster) else _INVISIBLE
    if len(cluster) == 1 and ord(cluster) < 0x20:
        return chr(_CONTROL_PICTURES + ord(cluster))
    kept = "".join(character if character.isprintable() else "" for character in cluster)
    return kept if kept and cell_len(kept) else _INVISIBLE


@lru_cache(4096)
def line_of(text: bytes) -> Line:
    """Return the layout of a line; that of the lines on the screen is remembered."""
    return Line(text)


def is_word(character: int) -> bool:
    """Tell whether a byte belongs to a word: letters, digits, `_`, and all beyond ASCII."""
    return character >= 0x80 or character == 0x5F or chr(character).isalnum()
