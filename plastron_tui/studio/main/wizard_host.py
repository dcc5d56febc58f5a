"""The wizard, as the main screen opens it."""

from __future__ import annotations

from collections.abc import Sequence

from textual.screen import Screen
from textual.widget import Widget

from plastron_tui.diagnostics import Edit
from plastron_tui.session import Session

from .active_program import ActiveProgram


class WizardHost:
    """Opens the wizard, and takes what it writes."""

    def __init__(self, screen: Screen[None], program: ActiveProgram) -> None:
        self._screen = screen
        self._program = program
        self._focused: Widget | None = None
        self._has_written = False

    def open(self) -> None:
        """Build statements from menus and forms."""
        from ..wizard.screen import Wizard

        self._focused, self._has_written = self._screen.focused, False
        session = self._program.open.session.snapshot()
        # At once: what is typed next is meant for the wizard.
        self._screen.app.push_screen(Wizard(session, self._enter), self._closed)

    async def _closed(self, action: str | None) -> None:
        focused = self._focused
        # Keys that were meant for a panel are not to be typed into the program.
        if self._has_written or focused is None or not focused.is_attached:
            self._program.editor.focus()
        else:
            focused.focus()
        if action:
            await self._screen.run_action(action)

    def _enter(self, edits: Sequence[Edit]) -> Session:
        """Put statements into the program, as one step to undo; return the program then."""
        editor = self._program.editor
        editor.apply(edits)
        if edits:
            self._has_written = True
            last = edits[-1]
            end = last.span.start + len(last.text.rstrip("\n").encode())
            editor.go_to(end, walk="wizard")
        return self._program.open.session.snapshot()
