"""What the view of a text asks of who edits the text."""

from __future__ import annotations

from typing import Protocol


class Owner(Protocol):
    """Who edits the text that a view shows; keys and the mouse ask it to, as they come."""

    def type_text(self, text: str) -> None:
        """Type characters over what is selected."""

    def insert_text(self, text: str) -> None:
        """Put a text over what is selected, as a step of its own to undo."""

    def select_range(self, anchor: int, head: int) -> None:
        """Select a range."""

    def accept(self) -> None:
        """Write the entry of the popup that is marked."""
