"""Where the cursor jumped from, in the texts of all tabs, and the way back and forth."""

from __future__ import annotations

from typing import NamedTuple

from plastron_tui.session import Session

from .state import Edited, TextState

MOST = 50
"""How many places are kept each way."""


class Place(NamedTuple):
    """An offset in the text of a session."""

    session: Session
    offset: int


class Jumps:
    """Moves the cursor from place to place, and knows the places that it left.

    Edits of the text in the editor move its places along. A text that changes in another way is
    shorter than a place, at worst: whoever goes there clamps the offset.
    """

    def __init__(self, state: TextState) -> None:
        """Jump in the text of a state, whichever session it is of."""
        self._state = state
        self._before: list[Place] = []
        self._behind: list[Place] = []
        self._walked: tuple[str, Place] | None = None
        state.listeners.append(self._edited)

    @property
    def here(self) -> Place:
        """Where the cursor is."""
        return Place(self._state.buffer.session, self._state.cursor)

    def jump(self, anchor: int, head: int, walk: str = "") -> None:
        """Select a range, and remember where the cursor was.

        Args:
            anchor: where the selection begins.
            head: where the cursor is then.
            walk: what steps that follow each other belong to, from match to match for example:
                only where the first of them began is remembered. "" for a jump of its own.
        """
        here = self.here
        if not walk or self._walked != (walk, here):
            self.leave()
        self._state.select(anchor, head)
        self._walked = (walk, self.here) if walk else None

    def leave(self) -> None:
        """Remember where the cursor is, before it is somewhere else; there is no way forth then."""
        here = self.here
        if self._before and self._is_line_of(self._before[-1], here):
            self._before.pop()
        self._before = [*self._before, here][-MOST:]
        self._behind.clear()

    def turn(self, by: int) -> Place | None:
        """Return the place before this one, or with 1 the one behind; None where there is none.

        What is on the cursor's line is no other place.
        """
        here = self.here
        source, other = (self._before, self._behind) if by < 0 else (self._behind, self._before)
        while source:
            place = source.pop()
            if not self._is_line_of(place, here):
                other.append(here)
                return place
        return None

    def hand_on(self, old: Session, new: Session) -> None:
        """Let the places in the text of one session be places in that of another."""
        for places in (self._before, self._behind):
            places[:] = [each._replace(session=new) if each.session is old else each
                         for each in places]  # fmt: skip

    def forget(self, session: Session) -> None:
        """Forget the places in a text that is closed."""
        for places in (self._before, self._behind):
            places[:] = [each for each in places if each.session is not session]

    def _is_line_of(self, place: Place, here: Place) -> bool:
        """Tell whether a place is on the cursor's line."""
        if place.session is not here.session:
            return False
        buffer = self._state.buffer
        return buffer.row(min(place.offset, buffer.size)) == buffer.row(here.offset)

    def _edited(self, edited: Edited) -> None:
        session = self._state.buffer.session
        for places in (self._before, self._behind):
            places[:] = [_moved(each, session, edited) for each in places]
        if self._walked is not None:
            walk, place = self._walked
            self._walked = walk, _moved(place, session, edited)


def _moved(place: Place, session: Session, edited: Edited) -> Place:
    """Return where a place is after an edit of a session's text."""
    offset = place.offset
    if place.session is not session or offset < edited.start:
        return place
    if offset >= edited.old_end:
        return Place(session, offset + edited.new_end - edited.old_end)
    return Place(session, min(offset, edited.new_end))
