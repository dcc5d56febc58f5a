"""Which nodes the live panel shows, where those of several tabs run."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from .active_program import Tab
from .live_actions import LiveActions
from .tab_run import RunPanels, TabRun

_BUILDING = "building `"
"""How a line begins that says how far a build is (see `ProgressLine`)."""


class WatchedRun:
    """Shows what travels between the nodes that were started last.

    Attributes:
        live: starts and ends their monitors.
    """

    def __init__(self, live: LiveActions, panels: RunPanels) -> None:
        self.live = live
        self._panels = panels
        self._tab: Tab | None = None
        """Whose monitors the live panel has."""

    def starting(self) -> None:
        """Show that nodes are about to run, unless others are watched."""
        if self._tab is None:
            self.live.starting()

    def preparing(self, printed: Sequence[str]) -> None:
        """Show what is built before nodes start, unless others are watched."""
        steps = [line for line in printed if line.startswith(_BUILDING)]
        if steps and self._tab is None:
            self.live.preparing(steps[-1])

    def follow(self, runs: Mapping[Tab, TabRun], front: Tab) -> None:
        """Watch the nodes that were started last, of those that are ready.

        Args:
            runs: the nodes of each tab.
            front: the tab in front.
        """
        ready = [
            (run.started_at, tab, run.running)
            for tab, run in runs.items()
            if run.running is not None and run.running.monitors
        ]
        if not ready:
            return
        _, tab, running = max(ready, key=lambda each: each[0])
        if tab is self._tab:
            return
        if self._tab is not None:
            # What is known is of the nodes of another tab.
            self.live.starting()
        self._tab = tab
        self.live.start(tab, running.monitors)
        self.mark_ended(tab, runs[tab])
        # Somebody may have gone elsewhere since the nodes were started.
        if tab is front and self._panels.layout.is_in_sight("output"):
            self._panels.layout.reveal("live")

    def mark_ended(self, tab: Tab, run: TabRun) -> None:
        """Mark the nodes of a tab that have ended by themselves, where that tab is watched."""
        if self._tab is tab and run.ended:
            self.live.mark_ended(run.ended)

    def end(self, tab: Tab, *, others_run: bool) -> None:
        """Show no more of what travels by the monitors of a tab: its nodes have ended.

        Args:
            tab: whose nodes have ended.
            others_run: whether nodes of another tab run, or start just now.
        """
        if self._tab is tab or (self._tab is None and not others_run):
            self._tab = None
            self.live.end()

    def close(self) -> None:
        """End the monitors, because the studio ends."""
        self.live.close()
