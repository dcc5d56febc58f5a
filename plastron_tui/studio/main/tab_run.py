"""The nodes of a tab, and what shows them."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import chain
from typing import TYPE_CHECKING

from textual.widget import Widget

from plastron_tui.runtime.labels import SIGN, split_label
from plastron_tui.runtime.live_graph import NodeEnd

from ..panels.entry_list import EntryList
from ..panels.live_panel import LivePanel
from ..panels.output import OutputPanel
from ..panels.output_log import OutputLog, Record, printed_record
from ..same_meaning import says_the_same
from .dock_layout import DockLayout
from .program_bars import OLDER

if TYPE_CHECKING:
    from plastron_tui.runtime.monitor import MonitorCommand

    from ..running import Running

_BUILDING = re.compile(r"building `([^`]+)`: ")
"""How a line begins that says how far a build is (see `ProgressLine`)."""
_LOGGED = re.compile(r"^\[[A-Z]+\](?: \[[^\]]*\])*:? ")
"""What a logger puts before a line: how bad it is, when it was, and who says it."""
_TYPED = re.compile(r"\b\w+\.(?:msg|srv|action)\.\w+(?=\()")
"""The type of a message before its fields, as Python shows it."""


@dataclass(eq=False)
class TabRun:
    """The nodes of a tab.

    Attributes:
        log: what they have printed.
        failed: which have failed, by their names, and what is said of that.
        ended: how nodes have ended that nobody asked to, by their names.
        running: those that run, None for none.
        started_at: when they were started, by the clock of `monotonic`.
        built: the package that is built before they start, "" for none.
        built_since: when that was begun.
        speaks: whether a node has printed something.
        commands: what starts monitors of them, also when they have ended.
        said: the last line of each, by what their lines are labelled with.
        is_stopping: whether they were asked to end.
        text: the program that they were started from.
        is_older: whether the program says something else by now.
    """

    log: OutputLog = field(default_factory=OutputLog)
    failed: Mapping[str, str] = field(default_factory=dict)
    ended: Mapping[str, NodeEnd] = field(default_factory=dict)
    running: Running | None = None
    started_at: float = 0.0
    built: str = ""
    built_since: float = 0.0
    speaks: bool = False
    commands: Sequence[MonitorCommand] = ()
    said: dict[str, str] = field(default_factory=dict)
    is_stopping: bool = False
    text: bytes = b""
    is_older: bool = False

    @property
    def is_ready(self) -> bool:
        """Whether they can be watched."""
        return self.running is not None and bool(self.running.monitors) and not self.is_stopping

    @property
    def own(self) -> Mapping[int, frozenset[str]] | None:
        """Their names by the generation of ROS; None where the run has not said them."""
        found = {
            each.ros_version: frozenset(chain.from_iterable(each.nodes.values()))
            for each in self.commands
        }
        return None if self.commands and not any(found.values()) else found

    @property
    def labels(self) -> list[str]:
        """What the lines of the nodes are labelled with."""
        return [label for each in self.commands for label in each.nodes]

    def note_commands(self) -> None:
        """Note what starts monitors of them, as soon as that is known."""
        if self.running is not None and self.running.monitors:
            self.commands = self.running.monitors

    def compare(self, text: bytes) -> None:
        """Note whether the program says something else than the nodes were started from."""
        self.is_older = self.running is not None and not says_the_same(self.text, text)

    def note_progress(self, printed: Iterable[str], now: float) -> None:
        """Note which package is built, and whether nodes run, from what the run prints."""
        for line in printed:
            self.speaks = self.speaks or bool(split_label(line)[0])
            found = _BUILDING.match(line)
            if found is not None and found[1] != self.built:
                self.built, self.built_since = found[1], now

    def note_said(self, printed: Iterable[str]) -> None:
        """Note what each node has printed last."""
        for line in printed:
            label, text = split_label(line)
            if label and text.strip():
                said = _TYPED.sub("", _LOGGED.sub("", text)).strip()
                self.said[label.removesuffix(SIGN).rstrip()] = said

    def stage(self, now: float) -> str:
        """Return how far the nodes are: `starting`, built, `running`, `OLDER`, or "" for none.

        Args:
            now: the time by the clock of `monotonic`.
        """
        if self.running is None:
            return ""
        if self.running.is_started or self.speaks:
            return OLDER if self.is_older else "running"
        if self.built:
            return f"building {self.built}… {max(0, int(now - self.built_since))} s"
        return "starting"

    def add(self, printed: Iterable[str], end: Record | None) -> None:
        """Keep what was printed while another tab is in front; `end` says how the nodes ended."""
        self.log.add([*map(printed_record, printed), *([] if end is None else [end])])


@dataclass(frozen=True)
class RunPanels:
    """What shows nodes that run.

    Attributes:
        layout: brings a panel in sight.
        output: shows what nodes print.
        nodes: lists the nodes, and shows which have failed.
        live: shows what travels between the nodes.
    """

    layout: DockLayout
    output: OutputPanel
    nodes: EntryList
    live: LivePanel

    @classmethod
    def of(cls, panels: Mapping[str, Widget], layout: DockLayout) -> RunPanels:
        """Return those of all panels that show nodes that run."""
        output, nodes, live = panels["output"], panels["nodes"], panels["live"]
        assert isinstance(output, OutputPanel) and isinstance(nodes, EntryList)
        assert isinstance(live, LivePanel)
        return cls(layout, output, nodes, live)

    def follow(self, run: TabRun) -> None:
        """Show what the nodes of a tab have printed, and which have failed."""
        self.output.show_log(run.log)
        self.nodes.remark(run.failed)

    def begin(self, run: TabRun, title: str) -> None:
        """Show that the nodes of a tab are started, and nothing of those before."""
        self.nodes.remark(run.failed)
        self.output.begin(title)

    def add(self, run: TabRun, printed: Iterable[str], end: Record | None) -> None:
        """Show what the nodes of the tab in front have printed."""
        self.output.add(printed, end)
        self.nodes.remark(run.failed)
        if end is not None and end.tone == "error" and self.layout.is_in_sight("live"):
            # Why they ended is printed.
            self.layout.reveal("output")
