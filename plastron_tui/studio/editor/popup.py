"""The list of what completion offers, below the cursor."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from rich.cells import cell_len, set_cell_size
from rich.segment import Segment
from rich.style import Style
from textual import events
from textual.geometry import Offset
from textual.message import Message
from textual.strip import Strip
from textual.widget import Widget

from .completion import Candidate

_MOST_ROWS = 8
_WIDEST = 72
_NARROWEST = 16
_SEEN_TO_MEASURE = 40


class CompletionPopup(Widget, can_focus=False):
    """Shows candidates; the first is marked, but counts as chosen only when a key chose it."""

    DEFAULT_CSS = """
    CompletionPopup {
        display: none;
        overlay: screen;
        constrain: inside inflect;
        position: absolute;
        background: $panel;
        color: $foreground;
        width: 40;
        height: 8;
    }
    """

    class Accepted(Message):
        """A candidate was taken."""

        def __init__(self, candidate: Candidate) -> None:
            super().__init__()
            self.candidate = candidate

    def __init__(self) -> None:
        super().__init__()
        self._candidates: Sequence[Candidate] = ()
        self._detail: Callable[[Candidate], str] = lambda candidate: candidate.detail
        self._index = 0
        self._top = 0
        self._label_width = 0
        self.is_chosen = False

    @property
    def is_open(self) -> bool:
        """Whether anything is offered."""
        return bool(self._candidates)

    @property
    def candidates(self) -> Sequence[Candidate]:
        """What is offered."""
        return self._candidates

    @property
    def current(self) -> Candidate | None:
        """The candidate that is marked."""
        return self._candidates[self._index] if self._candidates else None

    def offer(
        self, candidates: Sequence[Candidate], detail: Callable[[Candidate], str], place: Offset
    ) -> None:
        """Show candidates below a cell of the screen."""
        self._candidates, self._detail = candidates, detail
        self._index = self._top = 0
        self.is_chosen = False
        rows = min(_MOST_ROWS, len(candidates))
        seen = candidates[:_SEEN_TO_MEASURE]
        self._label_width = max(cell_len(candidate.text) for candidate in seen)
        details = max(cell_len(detail(candidate)) for candidate in candidates[:rows])
        wanted = self._label_width + (details + 3 if details else 1) + 1
        width = min(max(wanted, _NARROWEST), _WIDEST, self.app.size.width)
        offset = Offset(max(0, min(place.x - 1, self.app.size.width - width)), place.y + 1)
        if place.y + 1 + rows > self.app.size.height - 1 and place.y >= rows:
            offset = Offset(offset.x, place.y - rows)
        if self.absolute_offset != offset:
            self.absolute_offset = offset
            self.refresh(layout=True)
        self.styles.width = width
        self.styles.height = rows
        self.display = True
        self.refresh()

    def close(self) -> None:
        """Offer nothing any more."""
        if self._candidates:
            self._candidates = ()
            self.is_chosen = False
            self.display = False

    def choose(self, by: int) -> None:
        """Mark another candidate."""
        if not self._candidates:
            return
        if self.is_chosen or by < 0:
            self._index = (self._index + by) % len(self._candidates)
        elif len(self._candidates) > 1:
            self._index = 1
        self.is_chosen = True
        rows = min(_MOST_ROWS, len(self._candidates))
        self._top = min(max(self._top, self._index - rows + 1), self._index)
        self.refresh()

    def accept(self) -> None:
        """Take the candidate that is marked."""
        current = self.current
        if current is not None:
            self.close()
            self.post_message(self.Accepted(current))

    def render_line(self, y: int) -> Strip:
        """Draw a candidate."""
        index, width = self._top + y, self.size.width
        style = self.rich_style
        if index >= len(self._candidates):
            return Strip.blank(width, style)
        candidate = self._candidates[index]
        if index == self._index:
            style = style + Style(reverse=True, bold=self.is_chosen)
        label = set_cell_size(candidate.text, min(self._label_width, max(1, width - 2)))
        room = width - cell_len(label) - 4
        detail = self._detail(candidate) if room > 0 else ""
        if cell_len(detail) > room:
            detail = set_cell_size(detail, max(0, room - 1)) + "…"
        text = f" {label}  "
        rest = set_cell_size(detail, max(0, width - cell_len(text)))
        return Strip([Segment(text, style), Segment(rest, style + Style(dim=True))])

    def on_click(self, event: events.Click) -> None:
        """Take the candidate that was clicked."""
        event.stop()
        index = self._top + event.y
        if index < len(self._candidates):
            self._index = index
            self.accept()

    def on_mouse_scroll_down(self, event: events.MouseScrollDown) -> None:
        """Mark the next candidate."""
        event.stop()
        self.choose(1)

    def on_mouse_scroll_up(self, event: events.MouseScrollUp) -> None:
        """Mark the candidate before."""
        event.stop()
        self.choose(-1)
