"""Which lines of the screen a row of the text takes."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Mapping
from itertools import accumulate

from .state import Edited


class WrapMap:
    """Maps rows to screen lines, when some rows take more than one.

    `extra` says how many lines a row takes beyond its first: because it is wrapped, or because
    a message stands below it.
    """

    def __init__(self) -> None:
        self._rows: list[int] = []
        self._before: list[int] = [0]
        self._first_lines: list[int] = []
        self.extra: dict[int, int] = {}

    def set(self, extra: Mapping[int, int]) -> None:
        """Set the extra lines of all rows."""
        self.extra = {row: extra[row] for row in sorted(extra) if extra[row] > 0}
        self._index()

    def set_rows(self, extra: Mapping[int, int]) -> bool:
        """Set the extra lines of some rows; tell whether that is a change."""
        if all(self.extra.get(row, 0) == more for row, more in extra.items()):
            return False
        self.set({**self.extra, **extra})
        return True

    def edited(self, edited: Edited) -> None:
        """Move along with an edit that changed the number of rows."""
        by = edited.new_rows - edited.old_rows
        if not by or not self.extra:
            return
        last = edited.row + edited.old_rows - 1
        moved = {}
        for row, extra in self.extra.items():
            if row <= edited.row:
                moved[row] = extra
            elif row > last:
                moved[row + by] = extra
        self.extra = moved
        self._index()

    @property
    def total_extra(self) -> int:
        """How many lines there are beyond one a row."""
        return self._before[-1]

    def line_of(self, row: int) -> int:
        """Return the first screen line of a row."""
        return row + self._before[bisect_right(self._rows, row - 1)] if self._rows else row

    def row_at(self, line: int) -> tuple[int, int]:
        """Return the row at a screen line, and which of the row's lines it is."""
        if not self._rows or line < 0:
            return line, 0
        index = bisect_right(self._first_lines, line) - 1
        if index < 0:
            return line, 0
        row, first = self._rows[index], self._first_lines[index]
        within = line - first
        extra = self.extra[row]
        return (row, within) if within <= extra else (row + within - extra, 0)

    def _index(self) -> None:
        self._rows = list(self.extra)
        self._before = list(accumulate(self.extra.values(), initial=0))
        self._first_lines = [
            row + before for row, before in zip(self._rows, self._before, strict=False)
        ]
