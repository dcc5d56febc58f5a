"""Notes of one matter: they are taken away once that is settled."""

from __future__ import annotations

from textual.notifications import SeverityLevel
from textual.screen import Screen

from plastron_tui.diagnostics.terminal import visible_text

from ..textual_private import forget_notes


class SaidNotes:
    """Shows notes, and takes away those that still are there."""

    def __init__(self, screen: Screen[None]) -> None:
        self._screen = screen
        self._said: set[str] = set()

    def say(
        self, text: str, *, severity: SeverityLevel = "information", timeout: float | None = None
    ) -> None:
        """Show a note, for a time in seconds where one is given."""
        self._said.add(visible_text(text))
        self._screen.notify(text, severity=severity, timeout=timeout, markup=False)

    def forget(self) -> None:
        """Take all notes away."""
        if self._said:
            said, self._said = self._said, set()
            forget_notes(self._screen.app, lambda note: note.message in said)
