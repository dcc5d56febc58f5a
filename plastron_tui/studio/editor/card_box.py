"""The card about a word, drawn over the editor's own lines.

As the list of completion it is no widget: to show one is to lay out the whole screen.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from rich.segment import Segment
from rich.style import Style
from textual.geometry import Offset, Region, Size
from textual.strip import Strip

from .palette import Palette

if TYPE_CHECKING:
    from .card import Card, CardLine

WIDEST = 72
_LEAST_ROWS = 2
_BOLD = Style(bold=True)
_UP, _DOWN = "▲", "▼"


def place_card(word: Offset, cursor_line: int, wanted: Size, view: Size) -> Region | None:
    """Return where a card lies: next to its word, and never over the cursor's line.

    Args:
        word: the cell that the word starts in, in cells of the view.
        cursor_line: the line of the view that the cursor is in; it may be out of sight.
        wanted: how large the card is.
        view: how large the view is.

    Returns:
        A region with as many lines as there is room for, None where there is too little.
    """
    top, bottom = 0, view.height
    if cursor_line < word.y:
        top = max(top, cursor_line + 1)
    elif cursor_line > word.y:
        bottom = min(bottom, cursor_line)
    below, above = bottom - word.y - 1, word.y - top
    is_below = below >= wanted.height or below >= above
    rows = min(wanted.height, below if is_below else above)
    if rows < min(_LEAST_ROWS, wanted.height):
        return None
    x = max(0, min(word.x - 1, view.width - wanted.width))
    return Region(x, word.y + 1 if is_below else word.y - rows, wanted.width, rows)


class CardBox:
    """Shows a card; one that is too long for its region scrolls.

    Attributes:
        card: what is shown, None for nothing.
        region: where it lies over the view, in cells of the view.
    """

    def __init__(self) -> None:
        self.card: Card | None = None
        self.region = Region(0, 0, 0, 0)
        self._lines: Sequence[CardLine] = ()
        self._top = 0

    @property
    def is_open(self) -> bool:
        """Whether a card is shown."""
        return self.card is not None

    def open(self, card: Card, word: Offset, cursor_line: int, view: Size) -> bool:
        """Show a card; tell whether there is room for it."""
        from .card import lines_of

        lines = lines_of(card, min(WIDEST, view.width) - 2)
        width = max(sum(len(run.text) for run in line) for line in lines) + 2
        width = max(width, *(Strip(_segments(line, None)).cell_length + 2 for line in lines))
        size = Size(min(width, view.width), len(lines))
        region = place_card(word, cursor_line, size, view)
        if region is None:
            return False
        self.card, self._lines, self.region, self._top = card, lines, region, 0
        return True

    def close(self) -> None:
        """Show none any more."""
        self.card = None

    def scroll(self, by: int) -> bool:
        """Show other lines of a card that is longer than its region; tell whether it is."""
        most = len(self._lines) - self.region.height
        if self.card is None or most <= 0:
            return False
        self._top = min(max(0, self._top + by), most)
        return True

    def over(self, strip: Strip, y: int, palette: Palette) -> Strip:
        """Lay the card's line over one of the view's lines."""
        x, top, width, height = self.region
        line = self._lines[self._top + y - top]
        sign = " "
        if y == top and self._top > 0:
            sign = _UP
        elif y == top + height - 1 and self._top + height < len(self._lines):
            sign = _DOWN
        inner = Strip(_segments(line, palette)).adjust_cell_length(width - 2, palette.popup)
        edges = Strip([Segment(" ", palette.popup)]), Strip([Segment(sign, palette.popup_quiet)])
        return Strip.join([strip.crop(0, x), edges[0], inner, edges[1], strip.crop(x + width)])


def _segments(line: CardLine, palette: Palette | None) -> list[Segment]:
    return [
        Segment(run.text, None if palette is None else _style(run.tone, palette)) for run in line
    ]


def _style(tone: str, palette: Palette) -> Style:
    match tone:
        case "title" | "warning":
            return palette.popup + _BOLD
        case "quiet":
            return palette.popup_quiet
        case _:
            return palette.popup
