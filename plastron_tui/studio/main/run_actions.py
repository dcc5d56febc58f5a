"""Generating the nodes of the program, and running them."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from time import monotonic
from typing import TYPE_CHECKING

from textual.message import Message
from textual.notifications import SeverityLevel
from textual.screen import Screen

from plastron_tui.diagnostics import Diagnostic, Severity, has_errors
from plastron_tui.diagnostics.terminal import visible_text
from plastron_tui.regular_files import reason

from ..delay import Delay
from ..panels.entry_list import EntryList
from ..panels.live_panel import LivePanel
from ..panels.output import OutputPanel
from ..panels.output_log import Record
from ..textual_private import forget_notes
from .active_program import ActiveProgram
from .dock_layout import DockLayout
from .file_actions import FileActions
from .live_actions import LiveActions
from .trust_prompt import TrustPrompt

if TYPE_CHECKING:
    from ..running import Running

_SHOWN_AFTER = 0.05
"""Seconds for which lines that nodes print are gathered."""

TWICE = 0.7
"""Seconds in which the key that starts the nodes is pressed again by mistake."""

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
        nodes: EntryList,
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
            nodes: lists the nodes, and shows which have failed.
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
        self._nodes = nodes
        self._said: set[str] = set()
        self._started_at = 0.0
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
            if not anew and monotonic() - self._started_at < TWICE:
                return
            self._layout.reveal("output")
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

    def _say(
        self, text: str, *, severity: SeverityLevel = "information", timeout: float | None = None
    ) -> None:
        """Say why nothing runs, or no longer."""
        self._said.add(visible_text(text))
        self._screen.notify(text, severity=severity, timeout=timeout, markup=False)

    def known(self, diagnostics: Sequence[Diagnostic]) -> None:
        """Take away what was said of mistakes, where there are none any more."""
        if self._said and not has_errors(diagnostics):
            self._unsay()

    def _unsay(self) -> None:
        said, self._said = self._said, set()
        forget_notes(self._screen.app, lambda note: note.message in said)

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
        self._say("the files go beside the program: save it first", timeout=4)
        return await self._files.save()

    async def _has_errors(self) -> bool:
        """Find out, as soon as that is known, whether the text has mistakes; then show them."""
        errors = await self._errors()
        if not errors:
            return False
        count = len(errors)
        said = f"{count} {'problem has' if count == 1 else 'problems have'} to be fixed first"
        self._say(self._trust.explain(errors) or said, severity="warning")
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
        self._started_at = monotonic()
        self._unsay()
        self._nodes.remark({})
        self._is_watched = False
        self._live.starting()
        self._output.begin(f"plastron run {path.name}")
        self._on_change()
        self._layout.reveal("output")

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
            end = Record("", words, tone)
            self._live.end()
            self._on_change()
        printed = running.take()
        self._output.add(printed, end)
        self._tell_failed(printed)

    def _tell_failed(self, printed: Iterable[str]) -> None:
        """Say which nodes have failed, and mark them."""
        from plastron_tui.runtime.console import ended_node

        for node, how in filter(None, map(ended_node, printed)):
            self._say(f"{node} {how}", severity="error", timeout=10)
            self._nodes.remark({**self._nodes.remarks, node: "has ended"})

    def _watch(self, running: Running) -> None:
        """Show what travels, where nobody has gone elsewhere since the nodes were started."""
        self._is_watched = True
        self._live.start(running.monitors)
        if self._layout.is_in_sight("output"):
            self._layout.reveal("live")
