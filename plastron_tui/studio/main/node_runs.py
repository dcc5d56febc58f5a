"""What runs nodes: it is made when somebody first runs any, and costs nothing before."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

from textual.screen import Screen

from ..panels.panel import PanelWidgets
from .active_program import ActiveProgram, Tab
from .dock_layout import DockLayout
from .file_actions import FileActions
from .trust_prompt import TrustPrompt

if TYPE_CHECKING:
    from ..analysis import Analysis
    from .run_actions import RunActions


@dataclass(eq=False)
class NodeRuns:
    """Tells of the nodes that run in each tab; as long as nothing was run, there are none.

    Attributes:
        screen: shows dialogs, and gets what nodes print.
        program: whose nodes they are.
        files: saves the program first.
        layout: brings panels in sight.
        panels: the widgets of panels, of which some show nodes that run.
        trust: says where only trust is missing.
        on_change: called when nodes start, or have ended.
    """

    screen: Screen[None]
    program: ActiveProgram
    files: FileActions
    layout: DockLayout
    panels: PanelWidgets
    trust: TrustPrompt
    on_change: Callable[[], object]

    @cached_property
    def actions(self) -> RunActions:
        """What generates, starts and stops nodes."""
        from .readiness import Readiness
        from .run_actions import RunActions
        from .tab_run import RunPanels

        ready = Readiness(self.screen, self.program, self.files, self.layout, self.trust)
        shown = RunPanels.of(self.panels, self.layout)
        return RunActions(self.screen, self.program, ready, shown, self.on_change)

    @property
    def _made(self) -> RunActions | None:
        return self.actions if "actions" in self.__dict__ else None

    def runs_in(self, tab: Tab) -> bool:
        """Tell whether nodes of a tab run."""
        return self._made is not None and self._made.runs_in(tab)

    @property
    def stage(self) -> str:
        """How far the nodes of the program in front are, such as `running`; "" for none."""
        return "" if self._made is None else self._made.stage

    def known(self, analysis: Analysis) -> None:
        """Follow what the text means: what was said of mistakes, and whether older nodes run."""
        if self._made is not None:
            self._made.known(analysis)

    def follow(self) -> None:
        """Show what the nodes of the program in front have printed, and which have failed."""
        if self._made is not None:
            self._made.follow()

    def forget(self, tab: Tab) -> None:
        """Have the nodes of a tab ended, because it is gone."""
        if self._made is not None:
            self._made.forget(tab)

    def close(self) -> None:
        """Have all nodes ended, because the studio ends."""
        if self._made is not None:
            self._made.close()
