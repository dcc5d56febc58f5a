"""Where the rows and the offsets of a text are on the screen."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from textual.geometry import Offset, Size

from .columns import TAB_WIDTH
from .marks import Mark, Marks, worst
from .rows import has_room
from .state import Edited, TextState
from .wrap_map import WrapMap
from .wrapping import sections

_MOST_BELOW = 500
"""With more mistakes than this none gets a line of its own below its row."""


_SCROLL_MARGIN = 2
_SIDE_STEP = 8


def scrolled_to(place: Offset, scroll: Offset, size: Size, *, center: bool) -> Offset:
    """Return how far to scroll to see a place, with some lines around it.

    A place far away, or with `center` any place out of sight, comes into the middle.
    """
    (x, y), (width, height) = scroll, size
    margin = 0 if center else min(_SCROLL_MARGIN, (height - 1) // 2)
    top = y
    if place.y < y + margin or place.y > y + height - 1 - margin:
        if center or not y - height <= place.y <= y + 2 * height:
            top = place.y - height // 2
        elif place.y < y + margin:
            top = place.y - margin
        else:
            top = place.y - height + 1 + margin
    left = x
    if place.x < x:
        left = max(0, place.x - _SIDE_STEP)
    elif place.x >= x + width:
        left = place.x - width + _SIDE_STEP
    return Offset(left, max(0, top))


class Geometry:
    """The screen lines of a text: rows wrapped to a width, messages below rows.

    Cells and screen lines count from the text's start, as if nothing was scrolled.
    """

    def __init__(self, state: TextState) -> None:
        self.state = state
        self.marks = Marks()
        self.width = 80
        self.is_wrapped = False
        self.lines = WrapMap()

    @property
    def height(self) -> int:
        """How many screen lines there are."""
        return self.state.buffer.row_count + self.lines.total_extra

    def sections(self, row: int) -> Sequence[tuple[int, int]]:
        """Return the pieces that a row is shown in, in byte columns."""
        line = self.state.buffer.line(row)
        if not self.is_wrapped or line.width < self.width:
            return [(0, line.size)]
        return sections(line, self.width)

    def place_lines(self) -> None:
        """Find the rows that take more than one line of the screen."""
        buffer = self.state.buffer
        rows: set[int] = set()
        if self.is_wrapped:
            width = self.width
            for row, line in enumerate(buffer.text.split(b"\n")):
                # No byte takes more cells than one, but a tab.
                if len(line) + (TAB_WIDTH - 1) * line.count(b"\t") >= width:
                    rows.add(row)
        rows |= self._marked_rows()
        self.lines.set({row: self._extra(row) for row in rows})

    def place_marks(self, marks: Marks) -> None:
        """Take other mistakes, and find the rows that take more lines or fewer with them.

        All other rows are where they were: to break long lines anew takes longer than a key may.
        """
        rows = self._marked_rows()
        self.marks = marks
        rows |= self._marked_rows()
        self.lines.set_rows({row: self._extra(row) for row in rows})

    def _marked_rows(self) -> set[int]:
        """Return the rows that may have a message below them."""
        if not 0 < len(self.marks) <= _MOST_BELOW:
            return set()
        return {self.state.buffer.row(start) for start in self.marks.starts()}

    def edited(self, edited: Edited) -> None:
        """Move the mistakes and the rows along with an edit."""
        self.marks.edited(edited)
        self.lines.edited(edited)

    def place_edited(self, edits: Iterable[Edited]) -> bool:
        """Lay out the rows that were edited; tell whether other rows have moved by it."""
        has_messages = 0 < len(self.marks) <= _MOST_BELOW
        if not self.is_wrapped and not self.lines.extra and not has_messages:
            return False
        last = self.state.buffer.row_count - 1
        rows = {row for edit in edits for row in range(edit.row, edit.row + edit.new_rows)}
        return self.lines.set_rows({row: self._extra(row) for row in rows if row <= last})

    def _extra(self, row: int) -> int:
        return len(self.sections(row)) - 1 + (self.message_below(row) is not None)

    def marks_of(self, row: int) -> list[Mark]:
        """Return the mistakes that start in a row."""
        if not len(self.marks):
            return []
        buffer = self.state.buffer
        end = buffer.next_start(row)
        # The last row has no line ending; a mistake at its very end is one of its own.
        return self.marks.between(buffer.start(row), end if end == buffer.end(row) else end - 1)

    def message_below(self, row: int) -> Mark | None:
        """Return the mistake whose message stands on a line below its row, None if none does."""
        if not 0 < len(self.marks) <= _MOST_BELOW:
            return None
        mark = worst(self.marks_of(row))
        line = self.state.buffer.line(row)
        if mark is None or has_room(line, mark.message, self.width):
            return None
        return mark

    def place_of(self, offset: int) -> Offset:
        """Return the cell and the screen line of an offset."""
        buffer = self.state.buffer
        row = buffer.row(offset)
        line, column = buffer.line(row), offset - buffer.start(row)
        first = self.lines.line_of(row)
        pieces = self.sections(row)
        within = max(0, sum(1 for start, _ in pieces if start <= column) - 1)
        return Offset(line.cell(column) - line.cell(pieces[within][0]), first + within)

    def offset_at(self, cell: int, screen_line: int) -> int:
        """Return the offset of the character at a cell of a screen line, or the nearest."""
        buffer = self.state.buffer
        row, within = self.lines.row_at(max(0, screen_line))
        if row >= buffer.row_count:
            return buffer.size
        pieces = self.sections(row)
        start, end = pieces[min(within, len(pieces) - 1)]
        line = buffer.line(row)
        column = line.column(line.cell(start) + max(0, cell))
        if end < line.size:
            column = min(column, line.previous_stop(end))
        return buffer.start(row) + min(column, end)

    def vertical(self, offset: int, by: int, goal: int | None) -> tuple[int, int]:
        """Return where a cursor comes by going lines up or down, and the cell that it aims at."""
        place = self.place_of(offset)
        aim = place.x if goal is None else goal
        screen_line = min(max(place.y + by, 0), self.height - 1) if abs(by) > 1 else place.y + by
        while 0 <= screen_line < self.height:
            row, within = self.lines.row_at(screen_line)
            if within < len(self.sections(row)):
                return self.offset_at(aim, screen_line), aim
            screen_line += 1 if by > 0 else -1
        return (0 if by < 0 else self.state.buffer.size), aim
