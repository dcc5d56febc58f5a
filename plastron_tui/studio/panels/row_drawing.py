"""Rows of a widget that are drawn again, some at a time."""

from __future__ import annotations

from collections.abc import Iterable

from textual.geometry import Region
from textual.widget import Widget

from ..delay import Delay

_ROWS_AT_ONCE = 16
_BETWEEN = 0.03
"""Seconds between the rows that are drawn at once and the next ones."""


class RowDrawing:
    """Draws rows of a widget again: a key that comes meanwhile waits for a few of them only.

    Who is on a slow line gets no more than what is new.
    """

    def __init__(self, widget: Widget) -> None:
        self._widget = widget
        self._stale: set[int] = set()
        self._drawing = Delay(widget, self._draw_some)

    def refresh(self, rows: Iterable[int]) -> None:
        """Draw rows again, soon."""
        self._stale.update(rows)
        if not self._drawing.is_waiting:
            self._draw_some()

    def _draw_some(self) -> None:
        top, height = int(self._widget.scroll_offset.y), self._widget.size.height
        in_sight = sorted(row for row in self._stale if top <= row < top + height)
        if not in_sight:
            self._stale.clear()
            return
        first = in_sight[0]
        drawn = range(first, min(first + _ROWS_AT_ONCE, in_sight[-1] + 1))
        self._stale.difference_update(drawn)
        self._widget.refresh(Region(0, first - top, self._widget.size.width, len(drawn)))
        self._drawing.start(_BETWEEN)
