"""Generating the nodes of the program, and running them."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from textual.message import Message
from textual.screen import Screen

from plastron_tui.diagnostics import Diagnostic, Severity
from plastron_tui.regular_files import reason

from ..delay import Delay
from ..panels.live_panel import LivePanel
from ..panels.output import OutputPanel
from ..panels.styles import Piece
from .active_program import ActiveProgram
from .dock_layout import DockLayout
from .file_actions import FileActions
from .live_actions import LiveActions
from .trust_prompt import TrustPrompt

if TYPE_CHECKING:
    from ..running import Running

_SHOWN_AFTER = 0.05
"""Seconds for which lines that nodes print are gathered."""

_LOOK = 0.01
"""Seconds after which is looked again whether the worker knows what the text means."""


class Printed(Message):
    """Nodes that run printed something, or ended."""


class RunActions:
    """Generates, starts and stops nodes."""

    def __init__(
        self,
        screen: Screen[None],
        program: ActiveProgram,
        files: FileActions,
        layout: DockLayout,
        output: OutputPanel,
        trust: TrustPrompt,
        live: LivePanel,
        on_change: Callable[[], object],
    ) -> None:
        """Prepare to run.

        Args:
            screen: shows dialogs, and gets `Printed`.
            program: whose nodes they are.
            files: saves the program first.
            layout: brings the output, or the problems, in sight.
            output: shows what nodes print.
            trust: says where only trust is missing.
            live: shows what travels between the nodes.
            on_change: called when nodes start, or have ended.
        """
        self._screen = screen
        self._delay = Delay(screen, self._show)
        self._program = program
        self._files = files
        self._layout = layout
        self._output = output
        self._trust = trust
        self._live = LiveActions(screen, program, live)
        self._is_watched = False
        self._on_change = on_change
        self._running: Running | None = None

    @property
    def is_running(self) -> bool:
        """Whether nodes run."""
        return self._running is not None

    async def generate(self) -> bool:
        """Show what would be written, then write it; tell whether files may be other ones now."""
        from ..screens.generate import GenerateDialog

        if not await self._has_place() or await self._has_errors():
            return False
        session = self._program.open.session
        await self._screen.app.push_screen_wait(GenerateDialog(session))
        session.files_changed()
        return True

    async def run(self, *, anew: bool = False) -> None:
        """Save, then start the nodes; those that run are stopped, and started `anew` if asked."""
        if self._running is not None:
            self._layout.bring("output", focus=True)
            self._running.stop()
            if not anew:
                return
            while self._running is not None:
                await asyncio.sleep(_LOOK)
        if not await self._has_place() or await self._has_errors():
            return
        if self._program.open.is_changed and not await self._files.save():
            return
        assert self._program.path is not None
        self._start(self._program.path)

    def stop(self) -> None:
        """Stop what runs."""
        if self._running is None:
            self._screen.notify("nothing runs", timeout=2)
        else:
            self._running.stop()

    def close(self) -> None:
        """Have the nodes ended, because the studio ends."""
        self._live.close()
        if self._running is not None:
            self._running.close()

    async def _has_place(self) -> bool:
        """Make sure that there is a folder to generate into: that of the program."""
        if self._program.path is not None:
            return True
        self._screen.notify("the files go beside the program: save it first", timeout=4)
        return await self._files.save()

    async def _has_errors(self) -> bool:
        """Find out, as soon as that is known, whether the text has mistakes; then show them."""
        errors = await self._errors()
        if not errors:
            return False
        count = len(errors)
        said = f"{count} {'mistake has' if count == 1 else 'mistakes have'} to be mended first"
        self._screen.notify(self._trust.explain(errors) or said, severity="warning")
        self._layout.bring("problems", focus=True)
        return True

    async def _errors(self) -> list[Diagnostic]:
        open_ = self._program.open
        while self._program.analysis is None and open_.failed != open_.text:
            await asyncio.sleep(_LOOK)
        known = self._program.analysis
        # What fails in the worker fails here too, and is said as the error that it is.
        found = open_.session.diagnostics if known is None else known.diagnostics
        return [each for each in found if each.severity is Severity.ERROR]

    def _start(self, path: Path) -> None:
        from ..running import Running

        try:
            self._running = Running(path, self._program.open.session.options, self._news)
        except OSError as error:
            message = f"cannot run: {reason(error)}"
            self._screen.notify(message, severity="error", markup=False)
            return
        self._is_watched = False
        self._live.starting()
        self._output.begin(f"plastron run {path.name}")
        self._on_change()
        self._layout.bring("output", focus=True)

    def _news(self) -> None:
        """Tell the screen, from the thread that reads."""
        self._screen.post_message(Printed())

    def show_soon(self) -> None:
        """Show what nodes print, soon: all that comes until then at once."""
        if not self._delay.is_waiting:
            self._delay.start(_SHOWN_AFTER)

    def _show(self) -> None:
        running = self._running
        if running is None:
            return
        status, end = running.status, None
        if running.monitors and not self._is_watched:
            self._watch(running)
        if status is not None:
            self._running = None
            words = "stopped" if running.was_stopped else f"ended with status {status}"
            tone = "quiet" if running.was_stopped else "success" if status == 0 else "error"
            end = Piece(words, tone)
            self._live.end()
            if tone == "error" and self._layout.is_in_sight("live"):
                # Why they ended is printed.
                has_focus = self._layout.focused_dock is self._layout.dock_of("live")
                self._layout.bring("output", focus=has_focus and not self._layout.shows_all)
            self._on_change()
        self._output.add(running.take(), end)

    def _watch(self, running: Running) -> None:
        """Show what travels, where nobody has gone elsewhere since the nodes were started."""
        self._is_watched = True
        self._live.start(running.monitors)
        if self._layout.focused_dock is self._layout.dock_of(self._output.id or ""):
            self._layout.bring("live", focus=not self._layout.shows_all)
