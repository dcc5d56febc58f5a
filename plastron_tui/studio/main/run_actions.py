"""Generating the nodes of the program, and running them."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Sequence
from pathlib import Path
from time import monotonic
from typing import TYPE_CHECKING

from textual.message import Message
from textual.screen import Screen

from plastron_tui.regular_files import reason
from plastron_tui.runtime.labels import ended_node
from plastron_tui.runtime.live_graph import NodeEnd

from ..delay import Delay
from ..panels.live_rows import said_now
from ..panels.output_log import Record
from .active_program import ActiveProgram, Tab
from .live_actions import LiveActions
from .program_bars import OLDER
from .readiness import Readiness
from .said_notes import SaidNotes
from .tab_run import RunPanels, TabRun
from .watched_run import WatchedRun

if TYPE_CHECKING:
    from ..analysis import Analysis
    from ..running import Running

_SHOWN_AFTER = 0.05
"""Seconds for which lines that nodes print are gathered."""

TWICE = 0.7
"""Seconds in which the key that starts the nodes is pressed again by mistake."""

_EACH = 1.0
"""Seconds after which is told again how far a build is."""

_LOOK = 0.01
"""Seconds after which is looked again whether nodes have ended that are started anew."""


class Printed(Message):
    """Nodes that run printed something, or ended."""


class RunActions:
    """Generates, starts and stops nodes; those of each tab go on while another is in front.

    Attributes:
        readiness: says what is missing before nodes can be generated or run.
        watched: shows what travels between the nodes.
    """

    def __init__(
        self,
        screen: Screen[None],
        program: ActiveProgram,
        readiness: Readiness,
        panels: RunPanels,
        on_change: Callable[[], object],
    ) -> None:
        """Prepare to run.

        Args:
            screen: shows dialogs, and gets `Printed`.
            program: whose nodes they are.
            readiness: makes sure that they can be generated, or run.
            panels: show what they print, and what is the case with them.
            on_change: called when nodes start, or have ended.
        """
        self._screen = screen
        self._program = program
        self._panels = panels
        self._on_change = on_change
        self._delay = Delay(screen, self._show)
        self._failures = SaidNotes(screen)
        self._stage = Delay(screen, self._tell_stage)
        self._runs = {program.tab: TabRun(panels.output.printed)}
        self.readiness = readiness
        self.watched = WatchedRun(LiveActions(screen, panels.live, program), panels)
        self.watched.live.on_written = self._note_written
        program.said_now = self._said_now

    @property
    def _run(self) -> TabRun:
        """The run of the tab in front."""
        return self._runs.setdefault(self._program.tab, TabRun())

    def runs_in(self, tab: Tab) -> bool:
        """Tell whether nodes of a tab run."""
        run = self._runs.get(tab)
        return run is not None and run.running is not None

    @property
    def is_running(self) -> bool:
        """Whether nodes of the program in front run, or are about to."""
        return self.runs_in(self._program.tab)

    @property
    def stage(self) -> str:
        """How far the nodes of the program in front are, "" for none."""
        return self._run.stage(monotonic())

    @property
    def is_older(self) -> bool:
        """Whether nodes of the program in front run that it has changed since."""
        return self._run.is_older

    def known(self, analysis: Analysis) -> None:
        """Follow what the text in front means."""
        self.readiness.known(analysis.diagnostics)
        self._run.compare(analysis.text)

    def _said_now(self, name: str) -> str:
        topic = self.watched.live.topic(name)
        return "" if topic is None else said_now(topic)

    def _note_written(self) -> None:
        """Note that the text has got what its nodes have: no run is older for that."""
        if not self._run.is_older:
            self._run.text = self._program.text

    def _tell_stage(self) -> None:
        """Tell how far the nodes in front are, each second until they run."""
        self._on_change()
        if self.stage not in ("", "running", OLDER):
            self._stage.start(_EACH)

    async def generate(self, *, only_new: bool = False) -> bool:
        """Show what would be written, then write it; tell whether files may be other ones now.

        Args:
            only_new: the program is saved, and files are written without being shown first where
                none is there yet.
        """
        from ..screens.generate import GenerateDialog
        from .new_files import write_new

        if not await self.readiness.to_write():
            return False
        if only_new and self._program.open.is_changed and not await self.readiness.files.save():
            return False
        session = self._program.open.session
        if not (only_new and write_new(session)):
            await self._screen.app.push_screen_wait(GenerateDialog(session))
        session.files_changed()
        return True

    async def run(self, *, anew: bool = False, focus: bool = False) -> None:
        """Save, then start the nodes; those that run are stopped, and started `anew` if asked.

        With `focus` Output gets the focus, and Live once it shows something.
        """
        tab, run = self._program.tab, self._run
        if run.running is not None and not anew:
            if monotonic() - run.started_at >= TWICE:
                self._stop(tab, run.running)
            return
        # Nodes that run go on where what is to take their place cannot be started.
        path = await self.readiness.to_run()
        if run.running is not None and path is not None:
            self._stop(tab, run.running)
            while self.runs_in(tab):
                await asyncio.sleep(_LOOK)
        if path is not None and tab is self._program.tab:
            self._start(path)
            if focus and run.running is not None:
                self._panels.layout.bring("output", focus=True)

    def stop(self) -> None:
        """Stop what runs of the program in front; say where else nodes run."""
        running = self._run.running
        if running is not None:
            self._stop(self._program.tab, running)
            return
        others = [tab.open.name for tab in self._runs if self.runs_in(tab)]
        said = f"nothing runs here; nodes run of {', '.join(others)}" if others else "nothing runs"
        self._screen.notify(said, timeout=2, markup=False)

    def _stop(self, tab: Tab, running: Running) -> None:
        if not self._panels.layout.is_in_sight("live"):
            self._panels.layout.reveal("output")
        running.stop()
        # What was seen last stays: nodes that end take their topics away one by one.
        run = self._runs[tab]
        run.is_stopping = True
        run.ended = {**dict.fromkeys(run.labels, NodeEnd("stopped", False)), **run.ended}
        self.watched.mark_ended(run)
        self._end_watch(tab)

    def close(self) -> None:
        """Have all nodes ended, because the studio ends."""
        self.watched.close()
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
            self.show_soon()

    def follow(self) -> None:
        """Show what the nodes of the program in front have printed, and which have failed."""
        self._panels.follow(self._run)
        self.watched.follow(self._runs, self._program.tab)
        self._tell_stage()

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
        run.text = self._program.open.saved
        run.compare(self._program.text)
        self._failures.forget()
        run.failed, run.ended, run.said, run.built, run.speaks = {}, {}, {}, "", False
        run.is_stopping = False
        self.watched.starting(run)
        run.commands = ()
        self._panels.begin(run, f"plastron run {path.name}")
        self._tell_stage()
        self._panels.layout.reveal("output")

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
        if any(run.running is not None and run.running.has_more for run in self._runs.values()):
            self.show_soon()
        self.watched.follow(self._runs, self._program.tab)

    def _show_run(self, tab: Tab, run: TabRun, running: Running) -> None:
        """Take what nodes of a tab have printed, and show it where the tab is in front."""
        is_in_front = tab is self._program.tab
        status, end = running.status, None
        printed = running.take()
        self._tell_ended(tab, run, printed)
        if not running.monitors:
            self.watched.preparing(printed)
            run.note_progress(printed, monotonic())
        if is_in_front and self._stage.is_waiting:
            self._tell_stage()
        if status is not None and not running.has_more:
            run.running, run.is_older = None, False
            words = "stopped" if running.was_stopped else f"ended with status {status}"
            tone = "quiet" if running.was_stopped else "success" if status == 0 else "error"
            end = Record("", words, tone)
            self._end_watch(tab)
            if not is_in_front:
                self._screen.notify(f"the nodes of {tab.open.name} have ended", markup=False)
            self._on_change()
        if is_in_front:
            self._panels.add(run, printed, end)
        else:
            run.add(printed, end)

    def _tell_ended(self, tab: Tab, run: TabRun, printed: Sequence[str]) -> None:
        """Mark the nodes that have ended, and say which have failed."""
        run.note_said(printed)
        for end in filter(None, map(ended_node, printed)):
            words, said = end.how.partition(":")[0], run.said.get(end.node, "")
            run.ended = {**run.ended, end.node: NodeEnd(words, end.is_failure, said)}
            if end.is_failure:
                self._failures.say(f"{end.node} {end.how}", severity="error", timeout=10)
                run.failed = {**run.failed, end.node: "has ended"}
        self.watched.mark_ended(run)

    def _end_watch(self, tab: Tab) -> None:
        others = (each for each in self._runs if each is not tab)
        self.watched.end(tab, others_run=any(map(self.runs_in, others)))
