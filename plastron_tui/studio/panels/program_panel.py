"""A panel of entries that can be acted on."""

from __future__ import annotations

from .acting import Acting
from .entry_list import EntryList


class ProgramPanel(EntryList, Acting):
    """Entries of a program, with what can be done about them."""

    def watch_index(self, old: int, new: int) -> None:
        """Offer other actions with another entry."""
        super().watch_index(old, new)
        if self.has_focus:
            self.refresh_bindings()
