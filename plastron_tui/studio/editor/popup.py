"""The list of what completion offers, drawn over the editor's own lines.

It is no widget: to show one is to lay out the whole screen, which takes longer than a key may.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from rich.cells import cell_len, set_cell_size
from rich.segment import Segment
from rich.style import Style
from textual.geometry import Offset, Region, Size
from textual.strip import Strip

from ..cells import fitted
from .candidate import Candidate
from .palette import Palette

_MOST_ROWS = 8
_WIDEST = 72
_NARROWEST = 16
_SEEN_TO_MEASURE = 40
_SWATCH = "■ "


class Popup:
    """Offers candidates; the first is marked, but counts as chosen only when a key chose it.

    `region` is where it lies over the view, in cells of the view.
    """

    def __init__(self) -> None:
        self.candidates: Sequence[Candidate] = ()
        self.region = Region(0, 0, 0, 0)
        self.is_chosen = False
        self._detail: Callable[[Candidate], str] = lambda candidate: candidate.detail
        self._index = 0
        self._top = 0
        self._label_width = 0

    @property
    def is_open(self) -> bool:
        """Whether anything is offered."""
        return bool(self.candidates)

    @property
    def current(self) -> Candidate | None:
        """The candidate that is marked."""
        return self.candidates[self._index] if self.candidates else None

    def offer(
        self,
        candidates: Sequence[Candidate],
        detail: Callable[[Candidate], str],
        word: Offset,
        view: Size,
    ) -> None:
        """Show candidates below a word, or above it where there is more room."""
        below, above = view.height - word.y - 1, word.y
        is_below = below >= min(_MOST_ROWS, len(candidates)) or below >= above
        rows = min(_MOST_ROWS, len(candidates), below if is_below else above)
        if rows < 1:
            self.close()
            return
        self.candidates, self._detail = candidates, detail
        self._index = self._top = 0
        self.is_chosen = False
        seen = candidates[:_SEEN_TO_MEASURE]
        self._label_width = max(cell_len(candidate.text) for candidate in seen)
        details = max(
            cell_len(detail(each)) + (cell_len(_SWATCH) if each.swatch else 0)
            for each in candidates[:rows]
        )
        wanted = self._label_width + (details + 4 if details else 2)
        width = min(max(wanted, _NARROWEST), _WIDEST, view.width)
        x = max(0, min(word.x - 1, view.width - width))
        self.region = Region(x, word.y + 1 if is_below else word.y - rows, width, rows)

    def close(self) -> None:
        """Offer nothing any more."""
        self.candidates = ()
        self.is_chosen = False

    def choose(self, by: int) -> None:
        """Mark another candidate."""
        if not self.candidates:
            return
        if self.is_chosen or by < 0:
            self._mark((self._index + by) % len(self.candidates))
        else:
            self._mark(min(by, len(self.candidates) - 1))

    def _mark(self, index: int) -> None:
        self._index = index
        self.is_chosen = True
        self._top = min(max(self._top, index - self.region.height + 1), index)

    def choose_at(self, y: int) -> bool:
        """Mark the candidate at a line of the view; tell whether there is one."""
        index = self._top + y - self.region.y
        if index >= len(self.candidates):
            return False
        self._mark(index)
        return True

    def over(self, strip: Strip, y: int, palette: Palette) -> Strip:
        """Lay the popup's line over one of the view's lines."""
        x, _, width, _ = self.region
        return Strip.join(
            [
                strip.crop(0, x),
                self._line(self._top + y - self.region.y, width, palette),
                strip.crop(x + width),
            ]
        )

    def _line(self, index: int, width: int, palette: Palette) -> Strip:
        candidate = self.candidates[index]
        is_here = index == self._index
        style = palette.popup_here if is_here else palette.popup
        quiet = palette.popup_here if is_here else palette.popup_quiet
        label = fitted(candidate.text, max(1, min(self._label_width, width - 2)))
        room = width - cell_len(label) - 4
        detail = fitted(self._detail(candidate), room) if room > 0 else ""
        text = f" {label}  " if room > 0 else f" {label} "
        room = max(0, width - cell_len(text))
        segments = [Segment(text, style)]
        if candidate.swatch and room > cell_len(_SWATCH):
            room -= cell_len(_SWATCH)
            segments.append(Segment(_SWATCH, quiet + Style(color=candidate.swatch)))
        segments.append(Segment(set_cell_size(detail, room), quiet))
        return Strip(segments).adjust_cell_length(width, style)
