"""What the lines of an editor's screen look like."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from textual.strip import Strip

from . import motions
from .columns import Line
from .geometry import Geometry
from .highlights import RowPaint, highlight
from .marks import worst
from .palette import Palette
from .rows import Canvas, Layer, Row, below, draw
from .state import TextState


class Frame(NamedTuple):
    """What a text is drawn in.

    Attributes:
        palette: the colours.
        width: the cells of a line, the gutter included.
        gutter: the cells of signs and line numbers.
        left: the first cell of the text that is shown.
        has_focus: whether keys come to the text.
        offers: whether a list of what can stand at the cursor is open: that is read first.
    """

    palette: Palette
    width: int
    gutter: int
    left: int
    has_focus: bool
    offers: bool = False


class Painter:
    """Draws the screen lines of a text, with all that lies over them.

    Attributes:
        paint: the highlights, by row, of the rows that were last in sight.
        matches: returns what is found of a search in a range of offsets.
        brackets: the offsets of the two that belong together at the cursor.
    """

    def __init__(
        self, state: TextState, geometry: Geometry, window: Callable[[], tuple[int, int]]
    ) -> None:
        """Draw a text.

        Args:
            state: the text.
            geometry: where its rows are.
            window: returns the first and the last row in sight, or near it.
        """
        self.paint: dict[int, RowPaint] = {}
        self.matches: Callable[[int, int], list[tuple[int, int]]] | None = None
        self.brackets: tuple[int, int] | None = None
        self._state = state
        self._geometry = geometry
        self._window = window

    def highlight(self) -> list[int]:
        """Ask for the highlights anew; return the rows that look different now."""
        old = self.paint
        self.paint = highlight(self._state.buffer, *self._window())
        return [row for row, paint in self.paint.items() if old.get(row) != paint]

    def match_brackets(self) -> None:
        """Find the brackets at the cursor."""
        buffer, cursor = self._state.buffer, self._state.cursor
        around = buffer.text[max(0, cursor - 1) : cursor + 1]
        if not any(bracket in around for bracket in b"()[]{}"):
            self.brackets = None
            return
        literal = [
            (painted.start, painted.end)
            for painted in self.paint.get(self._state.row, ())
            if painted.capture.startswith(("string", "comment"))
        ]
        self.brackets = motions.matching_brackets(buffer, cursor, literal)

    def draw(self, screen_line: int, frame: Frame) -> Strip:
        """Draw a screen line, counted from the start of the text."""
        row, line = self._geometry.lines.row_at(screen_line)
        if row >= self._state.buffer.row_count:
            return Strip.blank(frame.width, frame.palette.text)
        canvas = Canvas(frame.palette, frame.gutter, frame.width - frame.gutter, frame.left)
        pieces = self._geometry.sections(row)
        look = self._look(row, frame, pieces[min(line, len(pieces) - 1)])
        is_choosing = frame.offers and row == self._state.row
        message = None if is_choosing else worst([mark for _, _, mark in look.marks])
        if line >= len(pieces):
            return (
                below(look, canvas, message)
                if message
                else Strip.blank(frame.width, frame.palette.text)
            )
        if row in self._geometry.lines.extra and self._geometry.message_below(row):
            message = None
        start, end = pieces[line]
        return draw(look, canvas, start, end, message=message if end == look.line.size else None)

    def _look(self, row: int, frame: Frame, piece: tuple[int, int]) -> Row:
        """Return how a row looks; of what is found, only what is in sight of one of its pieces."""
        buffer, selection = self._state.buffer, self._state.selection
        start, line = buffer.start(row), buffer.line(row)
        if row not in self.paint:
            self.highlight()
        return Row(
            line,
            row + 1,
            self._state.row == row and frame.has_focus and selection.is_empty,
            self.paint.get(row, ()),
            [(mark.start - start, mark.end - start, mark) for mark in self._geometry.marks_of(row)],
            [*self._found(start, line, frame, piece), *self._layers(row, start, line, frame)],
        )

    def _found(self, start: int, line: Line, frame: Frame, piece: tuple[int, int]) -> list[Layer]:
        """Return the matches of a search that are in sight: a long line may have thousands."""
        if self.matches is None:
            return []
        left = line.cell(piece[0]) + frame.left
        first, last = line.column(left), line.next_stop(line.column(left + frame.width))
        return [
            Layer(begin - start, until - start, frame.palette.match)
            for begin, until in self.matches(start + first, start + min(last, piece[1]))
        ]

    def _layers(self, row: int, start: int, line: Line, frame: Frame) -> list[Layer]:
        palette, selection = frame.palette, self._state.selection
        layers: list[Layer] = []
        if not selection.is_empty and selection.start <= start + line.size:
            begin, until = selection.start - start, selection.end - start
            if until > 0:
                over = line.size + 1 if until > line.size else until
                layers.append(Layer(max(0, begin), over, palette.selection))
        if self.brackets is not None and frame.has_focus:
            layers += [
                Layer(at - start, at - start + 1, palette.bracket)
                for at in self.brackets
                if start <= at < start + line.size
            ]
        if self._state.row == row:
            column = self._state.cursor - start
            style = palette.cursor if frame.has_focus else palette.cursor_away
            layers.append(Layer(column, max(line.next_stop(column), column + 1), style))
        return layers
