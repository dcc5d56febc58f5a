"""A list of entries that are read whole: a long one goes on below itself."""

from __future__ import annotations

from bisect import bisect_right
from itertools import accumulate

from rich.segment import Segment
from rich.style import Style
from textual.geometry import Region, Size
from textual.strip import Strip

from .broken_lines import broken
from .entry import Entry
from .program_panel import ProgramPanel
from .styles import Line, Lines, Piece


class WrappedList(ProgramPanel):
    """Entries of a program, each over as many rows as it takes."""

    _width = 0
    """The cells of a row; 0 as long as nobody knows."""
    _ends: tuple[int, ...] = ()
    """Behind which row each entry ends."""

    def on_resize(self) -> None:
        """Break the entries anew."""
        # The last column is the scroll bar's, whether it is there or not.
        width = max(0, self.outer_size.width - 1)
        if width != self._width:
            self._width = width
            self.virtual_size = Size(1, self._count_rows())
            self.refresh()

    def _count_rows(self) -> int:
        width = self._width
        self._ends = tuple(accumulate(_height(entry, width) for entry in self._shown))
        return self._ends[-1] if self._ends else 0

    def _number_at(self, row: int) -> int:
        return bisect_right(self._ends, row)

    def _start_of(self, number: int) -> int:
        return self._ends[number - 1] if number else 0

    def watch_index(self, old: int, new: int) -> None:
        """Draw the two entries again, whatever rows they take."""
        super().watch_index(old, new)
        self.refresh()

    def _reveal(self, row: int) -> None:
        if row < len(self._ends):
            start = self._start_of(row)
            region = Region(0, start, 1, self._ends[row] - start)
            self.scroll_to_region(region, animate=False, force=True, x_axis=False)

    def render_line(self, y: int) -> Strip:
        """Draw a row of an entry."""
        row = y + self.scroll_offset.y
        number = self._number_at(row)
        if number >= len(self._shown):
            return super().render_line(y)
        width = self.scrollable_content_region.width
        base, is_lit = self._style_of(number)
        entry = self._shown[number]
        rows = rows_of(entry, self._width, is_folded=entry.key in self._folded)
        part = min(row - self._start_of(number), len(rows) - 1)
        segments = [
            Segment(text, base + (Style.null() if is_lit else self.tone(tone)))
            for text, tone in rows[part]
        ]
        return Strip(segments).adjust_cell_length(width, base)


def _height(entry: Entry, width: int) -> int:
    """Return how many rows an entry takes."""
    said = (entry.text, entry.detail, entry.warning)
    if not width:
        return 1
    if sum(map(len, said)) + 2 * entry.depth + 9 <= width and all(map(str.isascii, said)):
        return 1
    return len(rows_of(entry, width))


def rows_of(entry: Entry, width: int, *, is_folded: bool = False) -> Lines:
    """Return an entry as rows of at most so many cells; all but the first stand below its text."""
    sign = f"{entry.sign} " if entry.sign else ""
    line = [
        Piece(" " + "  " * entry.depth),
        Piece(sign, entry.tone),
        Piece(entry.text + ("…" if is_folded else ""), "" if entry.depth else "strong"),
    ]
    if entry.detail:
        line.append(Piece(f" {entry.detail}", "quiet"))
    rows = list(_broken(tuple(line), width, entry))
    if entry.edits or entry.warning:
        mark = Piece(f" {'⚑' if entry.edits else '⚠'} {entry.warning}".rstrip(),
                     "success" if entry.edits else "warning")  # fmt: skip
        whole = _broken((*rows[-1], mark), width, entry)
        # What can be done about it stands on a row of its own rather than in pieces.
        below = (Piece(" " * (2 * entry.depth + 2)), mark)
        rows[-1:] = whole if len(whole) == 1 else [rows[-1], *_broken(below, width, entry)]
    return tuple(rows)


def _broken(line: Line, width: int, entry: Entry) -> Lines:
    indent = 2 * entry.depth + 3
    return broken(line, width, indent if indent < width // 2 else 0)
