"""A panel of entries that can be acted on."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .entry_keys import Acting
from .entry_list import EntryList

if TYPE_CHECKING:
    from ..analysis import Analysis


class ProgramPanel(EntryList, Acting):
    """Entries of a program, with what can be done about them."""

    def request(self, analysis: Analysis | None, offset: int) -> bool:
        """Ask for all entries, wherever the cursor is."""
        return True

    def watch_index(self, old: int, new: int) -> None:
        """Offer other actions with another entry."""
        super().watch_index(old, new)
        if self.has_focus:
            self.refresh_bindings()
