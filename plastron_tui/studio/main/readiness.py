"""Whether a program can be generated and run: what is missing is asked for, or said."""

from __future__ import annotations

import asyncio
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from textual.screen import Screen

from plastron_tui.diagnostics import Diagnostic, Severity, counted, has_errors

from .active_program import ActiveProgram
from .dock_layout import DockLayout
from .file_actions import FileActions
from .generate_offer import offer_generating
from .said_notes import SaidNotes
from .trust_prompt import TrustPrompt

_LOOK = 0.01
"""Seconds after which is looked again whether the worker knows what the text means."""


@dataclass(eq=False)
class Readiness:
    """Makes sure that the program in front can be written, or run.

    Attributes:
        screen: shows dialogs.
        program: which program it is.
        files: saves it.
        layout: brings its problems in sight.
        trust: says where only trust is missing.
        notes: what was said of what is missing.
    """

    screen: Screen[None]
    program: ActiveProgram
    files: FileActions
    layout: DockLayout
    trust: TrustPrompt
    notes: SaidNotes = field(init=False)

    def __post_init__(self) -> None:
        self.notes = SaidNotes(self.screen)

    async def to_write(self, *, to_run: bool = False) -> bool:
        """Make sure that there is a folder, no mistake, and something to write or to run."""
        if not await self._has_place() or await self._has_errors():
            return False
        return await offer_generating(self.screen, self.program, to_run=to_run)

    async def to_run(self) -> Path | None:
        """Make sure that the nodes can be started; return the file that they are started from."""
        if not await self.to_write(to_run=True):
            return None
        if self.program.open.is_changed and not await self.files.save():
            return None
        self.notes.forget()
        return self.program.path

    def known(self, diagnostics: Sequence[Diagnostic]) -> None:
        """Take away what was said of mistakes, where there are none any more."""
        if not has_errors(diagnostics):
            self.notes.forget()

    async def _has_place(self) -> bool:
        """Make sure that there is a folder to generate into: that of the program."""
        if self.program.path is not None:
            return True
        return await self.files.save(title="Save the program first: its files go beside it")

    async def _has_errors(self) -> bool:
        """Find out, as soon as that is known, whether the text has mistakes; then show them."""
        errors = await self._errors()
        if not errors:
            return False
        verb = "has" if len(errors) == 1 else "have"
        said = f"{counted(len(errors), 'problem')} {verb} to be fixed first"
        self.notes.say(self.trust.explain(errors) or said, severity="warning")
        self.layout.bring("problems", focus=True)
        return True

    async def _errors(self) -> list[Diagnostic]:
        open_ = self.program.open
        while self.program.analysis is None and open_.failed != open_.text:
            await asyncio.sleep(_LOOK)
        known = self.program.analysis
        # What fails in the worker fails here too, and is said as the error that it is.
        found = open_.session.diagnostics if known is None else known.diagnostics
        return [each for each in found if each.severity is Severity.ERROR]
