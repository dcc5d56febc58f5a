"""Generating the nodes of the program, and running them."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
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
from ..panels.output_log import OutputLog, Record, printed_record
from ..textual_private import forget_notes
from .active_program import ActiveProgram, Tab
from .dock_layout import DockLayout
from .file_actions import FileActions
from .generate_offer import offer_generating
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


@dataclass(eq=False)
class TabRun:
    """The nodes of a tab.

    Attributes:
        log: what they have printed.
        failed: which have failed, by their names, and what is said of that.
        running: those that run, None for none.
        started_at: when they were started, by the clock of `monotonic`.
    """

    log: OutputLog
    failed: Mapping[str, str] = field(default_factory=dict)
    running: Running | None = None
    started_at: float = 0.0


class RunActions:
    """Generates, starts and stops nodes; those of each tab go on while another is in front."""

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
        self._trust = trust
        self._live = LiveActions(screen, live)
        self._watched: Tab | None = None
        """Whose monitors the live panel has."""
        self._on_change = on_change
        self._runs = {program.tab: TabRun(output.printed)}

    @property
    def _run(self) -> TabRun:
        """The run of the tab in front."""
        return self._runs.setdefault(self._program.tab, TabRun(OutputLog()))

    def runs_in(self, tab: Tab) -> bool:
        """Tell whether nodes of a tab run."""
        run = self._runs.get(tab)
        return run is not None and run.running is not None

    @property
    def is_running(self) -> bool:
        """Whether nodes of the program in front run."""
        return self.runs_in(self._program.tab)

    async def generate(self) -> bool:
        """Show what would be written, then write it; tell whether files may be other ones now."""
        from ..screens.generate import GenerateDialog

        if not await self._may_write(to_run=False):
            return False
        session = self._program.open.session
        await self._screen.app.push_screen_wait(GenerateDialog(session))
        session.files_changed()
        return True

    async def run(self, *, anew: bool = False) -> None:
        """Save, then start the nodes; those that run are stopped, and started `anew` if asked."""
        tab, run = self._program.tab, self._run
        if run.running is not None:
            if not anew and monotonic() - run.started_at < TWICE:
                return
            self._layout.reveal("output")
            run.running.stop()
            if not anew:
                return
            while self.runs_in(tab):
                await asyncio.sleep(_LOOK)
            if tab is not self._program.tab:
                return
        if not await self._may_write(to_run=True):
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
        """Stop what runs of the program in front; say where else nodes run."""
        running = self._run.running
        if running is not None:
            running.stop()
            return
        others = [tab.open.name for tab in self._runs if self.runs_in(tab)]
        said = f"nothing runs here; nodes run of {', '.join(others)}" if others else "nothing runs"
        self._screen.notify(said, timeout=2, markup=False)

    def close(self) -> None:
        """Have all nodes ended, because the studio ends."""
        self._live.close()
        for run in self._runs.values():
            if run.running is not None:
                run.running.close()

    def forget(self, tab: Tab) -> None:
        """Have the nodes of a tab ended, because it is gone."""
        run = self._runs.pop(tab, None)
        if run is not None and run.running is not None:
            run.running.close()
            self._screen.notify(f"the nodes of {tab.open.name} were stopped", markup=False)
            self._end_watch(tab)

    def follow(self) -> None:
        """Show what the nodes of the program in front have printed, and which have failed."""
        self._output.show_log(self._run.log)
        self._nodes.remark(self._run.failed)

    async def _may_write(self, *, to_run: bool) -> bool:
        """Make sure that there is a folder, no mistake, and something to write or to run."""
        if not await self._has_place() or await self._has_errors():
            return False
        return await offer_generating(self._screen, self._program, to_run=to_run)

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

        run = self._run
        try:
            run.running = Running(path, self._program.open.session.options, self._news)
        except OSError as error:
            message = f"cannot run: {reason(error)}"
            self._screen.notify(message, severity="error", markup=False)
            return
        run.started_at = monotonic()
        self._unsay()
        run.failed = {}
        self._nodes.remark(run.failed)
        if self._watched is None:
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
        for tab, run in list(self._runs.items()):
            if run.running is not None:
                self._show_run(tab, run, run.running)
        self._watch_newest()

    def _show_run(self, tab: Tab, run: TabRun, running: Running) -> None:
        """Take what nodes of a tab have printed, and show it where the tab is in front."""
        is_in_front = tab is self._program.tab
        status, end = running.status, None
        if status is not None:
            run.running = None
            words = "stopped" if running.was_stopped else f"ended with status {status}"
            tone = "quiet" if running.was_stopped else "success" if status == 0 else "error"
            end = Record("", words, tone)
            self._end_watch(tab)
            if not is_in_front:
                self._screen.notify(f"the nodes of {tab.open.name} have ended", markup=False)
            elif tone == "error" and self._layout.is_in_sight("live"):
                # Why they ended is printed.
                self._layout.reveal("output")
            self._on_change()
        printed = running.take()
        if is_in_front:
            self._output.add(printed, end)
        else:
            run.log.add([*map(printed_record, printed), *([] if end is None else [end])])
        self._tell_failed(run, printed)
        if is_in_front:
            self._nodes.remark(run.failed)

    def _tell_failed(self, run: TabRun, printed: Iterable[str]) -> None:
        """Say which nodes have failed, and mark them."""
        from plastron_tui.runtime.console import ended_node

        for node, how in filter(None, map(ended_node, printed)):
            self._say(f"{node} {how}", severity="error", timeout=10)
            run.failed = {**run.failed, node: "has ended"}

    def _watch_newest(self) -> None:
        """Show what travels between the nodes that were started last, of those that are ready."""
        ready = [
            (run.started_at, tab, run.running)
            for tab, run in self._runs.items()
            if run.running is not None and run.running.monitors
        ]
        if not ready:
            return
        _, tab, running = max(ready, key=lambda each: each[0])
        if tab is self._watched:
            return
        if self._watched is not None:
            # What is known is of the nodes of another tab.
            self._live.starting()
        self._watched = tab
        self._live.start(tab, running.monitors)
        # Somebody may have gone elsewhere since the nodes were started.
        if tab is self._program.tab and self._layout.is_in_sight("output"):
            self._layout.reveal("live")

    def _end_watch(self, tab: Tab) -> None:
        """Show no more of what travels by the monitors of a tab: its nodes have ended.

        The nodes of another tab that run, or start just now, are watched instead.
        """
        if self._watched is tab or (
            self._watched is None and not any(map(self.runs_in, self._runs))
        ):
            self._watched = None
            self._live.end()
            self.show_soon()
