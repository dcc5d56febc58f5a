"""The wizard, as the main screen opens it."""

from __future__ import annotations

from collections.abc import Sequence

from plastron_tui.diagnostics import Edit
from plastron_tui.session import Session

from .part import Part


class Wizarding(Part):
    """Opens the wizard, and takes what it writes."""

    def action_wizard(self) -> None:
        """Build statements from menus and forms."""
        from ..wizard.screen import Wizard

        session = self.open.session.snapshot()
        # At once: what is typed next is meant for the wizard.
        self.app.push_screen(Wizard(session, self.enter_statements), self._after_wizard)

    async def _after_wizard(self, action: str | None) -> None:
        self.editor.focus()
        if action:
            await self.run_action(action)

    def enter_statements(self, edits: Sequence[Edit]) -> Session:
        """Put statements into the program, as one step to undo; return the program then."""
        self.editor.apply(edits)
        if edits:
            last = edits[-1]
            self.editor.go_to(last.span.start + len(last.text.rstrip("\n").encode()))
        return self.open.session.snapshot()
