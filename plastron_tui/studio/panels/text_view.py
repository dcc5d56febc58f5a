"""Coloured lines that scroll: source files, diffs, what programs print, the graph."""

from __future__ import annotations

from typing import ClassVar

from rich.cells import cell_len
from rich.segment import Segment
from textual.binding import Binding, BindingType
from textual.geometry import Size
from textual.scroll_view import ScrollView
from textual.strip import Strip

from .styles import COMPONENTS, Lines, Piece, Toned, rest_of


class TextView(Toned, ScrollView, can_focus=True):
    """Lines that are read, not written; only those in sight are drawn."""

    DEFAULT_CSS = """
    TextView { background: $background; height: 1fr; overflow: auto auto; }
    TextView > .text-view--number { color: $foreground 65%; }
    """
    COMPONENT_CLASSES: ClassVar[set[str]] = {*COMPONENTS, "text-view--number"}
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("up,k", "scroll_up", "Up", show=False),
        Binding("down,j", "scroll_down", "Down", show=False),
        Binding("left,h", "scroll_left", "Left", show=False),
        Binding("right,l", "scroll_right", "Right", show=False),
        Binding("home", "scroll_home", "Start", show=False),
        Binding("end", "scroll_end", "End", show=False),
        Binding("pageup", "page_up", "Page up", show=False),
        Binding("pagedown", "page_down", "Page down", show=False),
    ]

    def __init__(
        self,
        lines: Lines = (),
        *,
        numbers: bool = False,
        id: str | None = None,  # noqa: A002 - Textual's word
    ) -> None:
        super().__init__(id=id)
        self.lines = lines
        self.numbers = numbers
        self._marked: int | None = None

    def on_show(self) -> None:
        """Fit the first lines."""
        self._fit()

    def show(self, lines: Lines, *, numbers: bool | None = None, follow: bool = False) -> None:
        """Show other lines; with `follow` the last one stays in sight if it was."""
        was_at_end = self.is_vertical_scroll_end
        numbers = self.numbers if numbers is None else numbers
        if lines == self.lines and numbers == self.numbers:
            return
        self.lines, self.numbers = lines, numbers
        self._fit()
        if follow and was_at_end:
            self.scroll_end(animate=False, force=True)
        self.refresh()

    def mark_line(self, line: int | None) -> None:
        """Mark a line, from 1, where lines have numbers, and bring it in sight; None for none."""
        if line == self._marked:
            return
        self._marked = line
        self.refresh()
        if line is not None:
            # The lines may be there only since a moment ago, and the view not be laid out.
            self.call_after_refresh(self._reveal, line)

    def _reveal(self, line: int) -> None:
        top, height = int(self.scroll_offset.y), self.scrollable_content_region.height
        if line == self._marked and not top < line <= top + height:
            self.scroll_to(y=max(0, line - 1 - height // 3), animate=False, force=True)

    @property
    def text(self) -> str:
        """The lines without their colours."""
        return "\n".join("".join(piece.text for piece in line) for line in self.lines)

    @property
    def rows(self) -> Lines:
        """The lines as they are drawn."""
        return self.lines

    @property
    def _margin(self) -> int:
        return max(3, len(str(len(self.lines)))) + 1 if self.numbers else 0

    def _fit(self) -> None:
        widest = max((sum(cell_len(p.text) for p in line) for line in self.rows), default=0)
        self.virtual_size = Size(widest + self._margin + 1, len(self.rows))

    def render_line(self, y: int) -> Strip:
        """Draw a line."""
        width = self.scrollable_content_region.width
        base, rows = self.rich_style, self.rows
        x, top = self.scroll_offset
        row = top + y
        if row >= len(rows):
            return Strip.blank(width, base)
        margin = self._margin
        pieces = rows[row] or (Piece(""),)
        line = Strip([Segment(text, base + self.tone(tone)) for text, tone in pieces])
        rest = base + self.tone(next((tone for _, tone in rest_of(pieces)), ""))
        line = line.crop(x, x + width - margin).extend_cell_length(width - margin, rest)
        if not margin:
            return line
        is_marked = row + 1 == self._marked
        style = base + (self.tone("accent") if is_marked else self.tone("number", "text-view"))
        return Strip([Segment(f"{row + 1:>{margin - 1}}{'▸' if is_marked else ' '}", style), *line])
