"""When the card about a word is shown, and when it goes."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from textual import events
from textual.geometry import Offset
from textual.widget import Widget

from ..delay import Delay
from .state import TextState
from .view import EditorView

if TYPE_CHECKING:
    from .card import Card

_REST = 0.5
"""Seconds that the mouse rests over a word before its card is shown."""


class Hover:
    """Shows the card of the word under the cursor when asked, and of the one under the mouse."""

    def __init__(self, editor: Widget, state: TextState, view: EditorView) -> None:
        """Show cards over a view.

        Args:
            editor: what the mouse's messages go to.
            state: the text.
            view: what shows it.
        """
        self.card_of: Callable[[int], Card | None] = lambda _: None
        self._is_asked = False
        self._state = state
        self._view = view
        self._mouse: Offset | None = None
        self._rest = Delay(editor, self._rested)

    @property
    def is_asked(self) -> bool:
        """Whether a card is shown that somebody asked for."""
        return self._is_asked and self._view.card.is_open

    def show_at_cursor(self, hint: str = "") -> bool:
        """Show the card of the word at the cursor, a hint below it; tell whether there is one."""
        self._view.close_popup()
        card = self.card_of(self._state.cursor)
        if card is None:
            return False
        self._is_asked = self._show(card.with_hint(hint) if hint else card)
        return self._is_asked

    def close(self) -> None:
        """Show no card, and none for where the mouse is."""
        self._rest.stop()
        self._close()

    def _close(self) -> None:
        box = self._view.card
        if box.is_open:
            box.close()
            self._view.refresh(box.region)

    def scroll(self, by: int) -> bool:
        """Scroll the card that somebody asked for; tell whether there is more of it."""
        box = self._view.card
        if not (self.is_asked and box.is_open and box.scroll(by)):
            return False
        self._view.refresh(box.region)
        return True

    def mouse_moved(self, event: events.MouseMove) -> None:
        """Wait for the mouse to rest; a card stays as long as it is over its word, or over it."""
        if event.button or self.is_asked:
            return
        place = event.get_content_offset_capture(self._view)
        box = self._view.card
        if box.is_open and (box.region.contains(*place) or self._is_over(box.card, place)):
            return
        self._close()
        self._mouse = place
        self._rest.start(_REST)

    def mouse_left(self) -> None:
        """Show no card of a word that the mouse has left."""
        if not self.is_asked:
            self.close()

    def _rested(self) -> None:
        place, view = self._mouse, self._view
        if place is None or view.popup.is_open or self.is_asked:
            return
        card = self.card_of(view.offset_at(place))
        if card is not None and self._is_over(card, place):
            self._is_asked = False
            self._show(card)

    def _is_over(self, card: Card | None, place: Offset) -> bool:
        """Tell whether a cell of the view shows a character of the word of a card."""
        view = self._view
        offset = view.offset_at(place)
        if card is None or not card.span.start <= offset < card.span.end:
            return False
        # Beyond the end of a line the nearest character is its last.
        cell = view.cell_of(offset)
        return cell.y == place.y and place.x - cell.x in (0, 1)

    def _show(self, card: Card) -> bool:
        view = self._view
        self._close()
        word, cursor = view.cell_of(card.span.start), view.cell_of(self._state.cursor)
        size = view.scrollable_content_region.size
        is_shown = view.card.open(card, word, cursor.y, size)
        view.refresh(view.card.region)
        return is_shown
