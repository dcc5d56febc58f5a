"""What a line of the editor's screen looks like."""

from __future__ import annotations

from collections.abc import Callable

from textual.reactive import reactive
from textual.scroll_view import ScrollView
from textual.strip import Strip

from .columns import Line
from .geometry import Geometry
from .highlights import RowPaint, highlight
from .marks import Marks, worst
from .palette import Palette, ansi_palette, themed_palette, without_colors
from .popup import Popup
from .rows import Canvas, Layer, Row, below, draw
from .state import TextState

_OVERSCAN = 8


class DrawnText(ScrollView, inherit_bindings=False):
    """Draws the rows of a `TextState`, with all that lies over them."""

    soft_wrap: reactive[bool] = reactive(False)
    line_numbers: reactive[bool] = reactive(True)

    def __init__(self, state: TextState) -> None:
        super().__init__(id="editor-view")
        self.state = state
        self.marks = Marks()
        self.geometry = Geometry(state, self.marks)
        self.popup = Popup()
        self.matches: Callable[[int, int], list[tuple[int, int]]] | None = None
        self.brackets: tuple[int, int] | None = None
        self.paint: dict[int, RowPaint] = {}
        self._palette: Palette | None = None

    def recolor(self) -> None:
        """Draw in the colours of another theme."""
        self._palette = None
        self.refresh()

    def notify_style_update(self) -> None:
        """Follow colours that a style sheet changes."""
        super().notify_style_update()
        self._palette = None

    @property
    def palette(self) -> Palette:
        """The colours, made when they are first needed."""
        if self._palette is None:
            if self.app.native_ansi_color:
                self._palette = ansi_palette()
            else:
                _, _, background, foreground = self.colors
                self._palette = themed_palette(
                    self.app.theme_variables, background.blend(foreground, 1, 1), background
                )
            if self.app.no_color:
                self._palette = without_colors(self._palette)
        return self._palette

    @property
    def gutter_width(self) -> int:
        """The cells that signs and line numbers take."""
        if not self.line_numbers:
            return 0
        return max(3, len(str(self.state.buffer.row_count))) + 2

    @property
    def text_width(self) -> int:
        """The cells that are there for text."""
        return max(1, self.scrollable_content_region.width - self.gutter_width)

    def window(self) -> tuple[int, int]:
        """Return the first and the last row on the screen, and some around them."""
        top = self.scroll_offset.y
        last_row = self.state.buffer.row_count - 1
        first, _ = self.geometry.lines.row_at(max(0, top - _OVERSCAN))
        last, _ = self.geometry.lines.row_at(top + self.size.height + _OVERSCAN)
        first = min(first, last_row)
        return first, max(first, min(last, last_row))

    def _paint_of(self, row: int) -> RowPaint:
        paint = self.paint.get(row)
        if paint is None:
            self.paint = highlight(self.state.buffer, *self.window())
            paint = self.paint.get(row, ())
        return paint

    def render_line(self, y: int) -> Strip:
        """Draw a line of the screen."""
        strip = self._text_line(y)
        popup = self.popup
        if popup.is_open and y in popup.region.line_range:
            return popup.over(strip, y, self.palette)
        return strip

    def _text_line(self, y: int) -> Strip:
        buffer = self.state.buffer
        row, line = self.geometry.lines.row_at(self.scroll_offset.y + y)
        width = self.scrollable_content_region.width
        if row >= buffer.row_count:
            return Strip.blank(width, self.palette.text)
        left = 0 if self.soft_wrap else self.scroll_offset.x
        canvas = Canvas(self.palette, self.gutter_width, width - self.gutter_width, left)
        look = self._look(row)
        pieces = self.geometry.sections(row)
        message = worst([mark for _, _, mark in look.marks])
        if line >= len(pieces):
            return below(look, canvas, message) if message else Strip.blank(width)
        if row in self.geometry.lines.extra and self.geometry.message_below(row):
            message = None
        start, end = pieces[line]
        return draw(look, canvas, start, end, message=message if end == look.line.size else None)

    def _look(self, row: int) -> Row:
        buffer, selection = self.state.buffer, self.state.selection
        start = buffer.start(row)
        line = buffer.line(row)
        found = self.geometry.marks_of(row)
        marks = [(mark.start - start, mark.end - start, mark) for mark in found]
        here = self.state.row == row
        return Row(
            line,
            row + 1,
            here and self.has_focus and selection.is_empty,
            self._paint_of(row),
            marks,
            self._layers(row, start, line),
        )

    def _layers(self, row: int, start: int, line: Line) -> list[Layer]:
        palette, selection = self.palette, self.state.selection
        layers: list[Layer] = []
        if self.matches is not None:
            layers += [
                Layer(begin - start, until - start, palette.match)
                for begin, until in self.matches(start, start + line.size)
            ]
        if not selection.is_empty and selection.start <= start + line.size:
            begin, until = selection.start - start, selection.end - start
            if until > 0:
                over = line.size + 1 if until > line.size else until
                layers.append(Layer(max(0, begin), over, palette.selection))
        if self.brackets is not None and self.has_focus:
            layers += [
                Layer(at - start, at - start + 1, palette.bracket)
                for at in self.brackets
                if start <= at < start + line.size
            ]
        if self.state.row == row:
            column = self.state.cursor - start
            style = palette.cursor if self.has_focus else palette.cursor_away
            layers.append(Layer(column, max(line.next_stop(column), column + 1), style))
        return layers
