"""Which nodes the live panel shows, where those of several tabs run."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from plastron_tui.runtime.monitor import joined

from .active_program import Tab
from .live_actions import LiveActions
from .tab_run import RunPanels, TabRun

_BUILDING = "building `"
"""How a line begins that says how far a build is (see `ProgressLine`)."""


class WatchedRun:
    """Shows what travels between the nodes that run, those of the tab in front first.

    Attributes:
        live: starts and ends their monitors.
    """

    def __init__(self, live: LiveActions, panels: RunPanels) -> None:
        self.live = live
        self._panels = panels
        self._newest: Tab | None = None
        """The tab whose nodes were started last, of those that are watched."""
        self._watched: list[Tab] = []

    def starting(self, run: TabRun) -> None:
        """Show that nodes are about to run, unless others are watched."""
        if self._newest is None:
            self.live.starting()
        self.live.forget_ends(run.commands)

    def preparing(self, printed: Sequence[str]) -> None:
        """Show what is built before nodes start, unless others are watched."""
        steps = [line for line in printed if line.startswith(_BUILDING)]
        if steps and self._newest is None:
            self.live.preparing(steps[-1])

    def follow(self, runs: Mapping[Tab, TabRun], front: Tab) -> None:
        """Watch the nodes that are ready, and tell which of them are of the tab in front.

        Args:
            runs: the nodes of each tab.
            front: the tab in front.
        """
        for run in runs.values():
            run.note_commands()
        ready = sorted(
            (tab for tab, run in runs.items() if run.is_ready),
            key=lambda tab: -runs[tab].started_at,
        )
        sessions = dict.fromkeys(tab.open.session for tab in (front, *ready[:1]))
        self.live.follow(runs[front].own if front in runs else {}, tuple(sessions))
        if not ready or ready == self._watched:
            return
        newest = ready[0]
        is_new = newest is not self._newest
        self._newest, self._watched = newest, ready
        self.live.watch(joined([runs[tab].commands for tab in ready]))
        for tab in ready:
            self.mark_ended(runs[tab])
        # Somebody may have gone elsewhere since the nodes were started.
        if is_new and newest is front and self._panels.layout.is_in_sight("output"):
            self._panels.layout.reveal("live")

    def mark_ended(self, run: TabRun) -> None:
        """Mark the nodes of a run that have ended by themselves."""
        if run.ended:
            self.live.mark_ended(run.commands, run.ended)

    def end(self, tab: Tab, *, others_run: bool) -> None:
        """Watch the nodes of a tab no more: they have ended, or are about to.

        Args:
            tab: whose nodes they are.
            others_run: whether nodes of another tab run, or start just now.
        """
        self._watched = [each for each in self._watched if each is not tab]
        if self._newest is tab:
            self._newest = self._watched[0] if self._watched else None
        if not others_run:
            self.live.end()

    def close(self) -> None:
        """End the monitors, because the studio ends."""
        self.live.close()
