"""What programs print: each line is seen whole, below itself where it is long."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterable
from itertools import accumulate

from rich.cells import cell_len
from textual.geometry import Size

from plastron_tui.diagnostics.wording import counted
from plastron_tui.runtime.labels import split_label

from ..cells import cut
from .broken_lines import broken
from .output_log import TIMES
from .styles import Line, Lines, Piece
from .text_view import TextView

_CLOCK = re.compile(r"\d\d:\d\d:\d\d\.\d ")
"""When a line came, where that is shown."""
_MOST_KEPT = 6000
"""So many lines are kept as they were broken: a filter shows most of them again."""


Broken = tuple[int, dict[Line, Lines]]
"""A width, and lines as they are broken for it."""


MOST_ROWS = 3
"""So many rows of a long line are shown: many values would leave no room for other lines."""


class LogView(TextView):
    """Lines that are broken where the panel ends; what follows stands behind the node's name.

    Attributes:
        is_whole: whether all rows of long lines are shown.
        has_long: whether a line has had more rows than are shown.
    """

    is_whole = False
    has_long = False
    _rows: Lines = ()
    _room = (0, 0)
    _heights: tuple[int, ...] = ()
    """How many rows each line takes; empty as long as nobody knows."""
    _broken: Broken = (0, {})

    @property
    def rows(self) -> Lines:
        """The lines as they are drawn."""
        return self._rows

    def on_resize(self) -> None:
        """Break the lines anew; who saw the last one still does."""
        was_at_end = self.scroll_offset.y + self._room[1] >= len(self._rows)
        self._fit()
        if was_at_end:
            self.scroll_end(animate=False, force=True)
        self.refresh()

    def toggle_whole(self) -> None:
        """Show all rows of long lines, or the first ones again; what is at the top stays there."""
        was_at_end = self.is_vertical_scroll_end
        ends = list(accumulate(self._heights))
        first = bisect_right(ends, self.scroll_offset.y)
        self.is_whole = not self.is_whole
        self._broken = (0, {})
        self._fit()
        if was_at_end:
            self.scroll_end(animate=False, force=True)
        else:
            self.scroll_to(y=sum(self._heights[:first]), animate=False, force=True, immediate=True)
        self.refresh()

    def _fit(self) -> None:
        # The last column is the scroll bar's, whether it is there or not.
        width, height = self.outer_size
        self._room = width, height
        if width > 1:
            broken = self._wrapped(self.lines, width - 1)
            self._heights = tuple(map(len, broken))
            self._rows = tuple(row for rows in broken for row in rows)
            self.virtual_size = Size(width - 1, len(self._rows))

    def _wrapped(self, lines: Iterable[Line], width: int) -> list[Lines]:
        """Break lines for a width, each one once."""
        if self._broken[0] != width or len(self._broken[1]) > _MOST_KEPT:
            self._broken = (width, {})
        known = self._broken[1]
        found = []
        for line in lines:
            rows = known.get(line)
            if rows is None:
                rows = wrapped(line, width)
                if len(rows) > MOST_ROWS:
                    self.has_long = True
                    rows = rows if self.is_whole else first_rows(line, rows, width)
                known[line] = rows
            found.append(rows)
        return found

    def splice(self, dropped: int, start: int, lines: Lines) -> None:
        """Replace the lines from one on, and drop the first ones.

        Only the new ones are broken into rows. Who sees the last one still does, and who reads
        further up still sees the same.

        Args:
            dropped: how many of the first lines go.
            start: from which line on, as they are counted before, others come.
            lines: those others.
        """
        was_at_end = self.is_vertical_scroll_end
        width = self._room[0]
        kept = self.lines[dropped:start]
        if width <= 1 or len(self._heights) != len(self.lines):
            self.show((*kept, *lines), follow=True)
            return
        above = sum(self._heights[:dropped])
        below = above + sum(self._heights[dropped:start])
        broken = self._wrapped(lines, width - 1)
        self.lines = (*kept, *lines)
        self._heights = (*self._heights[dropped:start], *map(len, broken))
        self._rows = (*self._rows[above:below], *(row for rows in broken for row in rows))
        self.virtual_size = Size(width - 1, len(self._rows))
        if was_at_end:
            self.scroll_end(animate=False, force=True)
        elif above:
            top = max(0, self.scroll_offset.y - above)
            self.scroll_to(y=top, animate=False, force=True, immediate=True)
        self.refresh()


def first_rows(line: Line, rows: Lines, width: int) -> Lines:
    """Return the first rows of a line, with how many there are more; an error is seen whole."""
    if any(piece.tone == "error" for piece in line):
        return rows
    *first, last = rows[:MOST_ROWS]
    # How often it was printed stands behind it, and is seen as well.
    times = line[-1].text if line[-1].text.startswith(TIMES) else ""
    more = f" … {counted(len(rows) - MOST_ROWS, 'row')} more{times}"
    if cell_len(more) * 3 > width * 2:
        more = cut(f" …{times}", width - 1)
    kept = broken(last, width - cell_len(more), 0)[0]
    return (*first, (*kept, Piece(more, "quiet")))


def wrapped(line: Line, width: int) -> Lines:
    """Break a line into rows of at most so many cells, where it has a stop.

    All but the first are indented to the text behind the node's name, where it leaves room.
    """
    text = "".join(piece.text for piece in line)
    clock = _CLOCK.match(text)
    start = 0 if clock is None else clock.end()
    label, _ = split_label(text[start:])
    indent = start + (cell_len(label) or 2)
    return broken(line, width, min(2, width // 2) if indent > width // 2 else indent)
