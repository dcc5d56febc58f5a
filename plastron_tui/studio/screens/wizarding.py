"""The wizard, as the main screen opens it."""

from __future__ import annotations

from collections.abc import Sequence

from textual import work

from plastron_tui.diagnostics import Edit
from plastron_tui.session import Session

from .part import Part


class Wizarding(Part):
    """Opens the wizard, and takes what it writes."""

    @work(exclusive=True, group="wizard")
    async def action_wizard(self) -> None:
        """Build statements from menus and forms."""
        from ..wizard.screen import Wizard

        session = self.open.session.snapshot()
        action = await self.app.push_screen_wait(Wizard(session, self.enter_statements))
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
