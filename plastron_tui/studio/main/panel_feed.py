"""How the panels come to what they show: a worker finds out what the text means."""

from __future__ import annotations

from typing import TYPE_CHECKING

from textual.screen import Screen

from plastron_tui.diagnostics import Diagnostic

from ..analysis_worker import AnalysisWorker
from ..delay import Delay
from ..editor.preload import is_preloaded
from ..panels.entry import Entries
from ..panels.panel import Panel, PanelWidgets, ProgramView, Request
from ..panels.registry import PANELS, PROBLEMS, ROBOTS
from .active_program import ActiveProgram
from .dock_layout import DockLayout
from .held_back import HeldBack

if TYPE_CHECKING:
    from ..analysis import Analysis

_PAUSE = 0.01
"""Seconds without a key after which the worker starts."""

_FIRST_PAUSE = 0.05
"""The same at the start: the worker has much to import, and the first keys go before it."""


class PanelFeed:
    """Asks what the text means, and shows it in the panels that are in sight."""

    def __init__(
        self,
        screen: Screen[None],
        program: ActiveProgram,
        layout: DockLayout,
        widgets: PanelWidgets,
    ) -> None:
        """Prepare the worker.

        Args:
            screen: gets the worker's messages.
            program: what it is asked about.
            layout: knows which panels are in sight.
            widgets: the widgets of the panels.
        """
        self.worker = AnalysisWorker(screen.post_message)
        self._screen = screen
        self._program = program
        self._layout = layout
        self._widgets = widgets
        self._pause = Delay(screen, self._ask)
        self._asked: tuple[Request, ...] | None = None
        self.held_back = HeldBack(screen, program.editor, self._show_known)
        self._unheld: tuple[Entries, frozenset[Diagnostic], Entries] | None = None
        # The names that completion offers come with what the worker finds out.
        program.editor.completer.waits = True

    def start(self) -> None:
        """Begin to work, now that there is something to see."""
        self._pause.start(_FIRST_PAUSE)

    def _ask(self) -> None:
        """Ask, or have imported first what it takes to ask."""
        if is_preloaded():
            self.ask_anew()
        else:
            self.worker.preload()

    @property
    def is_pausing(self) -> bool:
        """Whether the text has changed and nobody was asked about it yet."""
        return self._pause.is_waiting

    def ask_soon(self) -> None:
        """Ask, as soon as no key comes, what the text means."""
        self._pause.start(_PAUSE if is_preloaded() else _FIRST_PAUSE)

    def ask_anew(self) -> None:
        """Ask what the text means now."""
        self._pause.stop()
        self._asked = self.wanted()
        self.worker.ask(self._asked, self._program.open.session.snapshot())

    def ask_more(self) -> None:
        """Ask for what came in sight, if it is not known."""
        wanted = self.wanted()
        if not self._pause.is_waiting and self._asked not in (None, wanted):
            self._asked = wanted
            self.worker.ask(wanted)

    def _view_of(self, panel: Panel) -> ProgramView:
        view = self._widgets[panel.name]
        assert isinstance(view, ProgramView)
        return view

    def _fed(self) -> list[Panel]:
        """Return the panels that are in sight, and those that raise an alarm, if they are fed."""
        is_in_sight = self._layout.is_in_sight
        return [each for each in PANELS if each.maker and (each.is_alarm or is_in_sight(each.name))]

    def wanted(self) -> tuple[Request, ...]:
        """Return what the panels in sight have to be given, and those that raise an alarm."""
        analysis, offset = self._program.open.analysis, self._program.editor.cursor_offset
        requests = (
            Request(panel.name, self._view_of(panel).request(analysis, offset))
            for panel in self._fed()
        )
        return tuple(request for request in requests if request.what is not None)

    def take(self, analysis: Analysis) -> bool:
        """Show what the text means; tell whether that is new. It may be about an older text."""
        open_ = self._program.open
        # Programs in several tabs may have the same text.
        if analysis.text != open_.text or analysis.session.path != open_.path:
            return False
        before, open_.analysis = open_.analysis, analysis
        is_new = analysis is not before
        if _has_first_robot(before, analysis) and self._layout.focused_dock is None:
            self._layout.bring(ROBOTS.name)
        if is_new:
            self._show_diagnostics(analysis)
        self.refresh()
        if is_new and before is not None:
            self.worker.discard(before)
        return is_new

    def _show_diagnostics(self, analysis: Analysis) -> None:
        """Show what is wrong, but for what is held back."""
        held = self.held_back.of(analysis.diagnostics)
        shown = [each for each in analysis.diagnostics if each not in held]
        meaning = (analysis.program, analysis.workspace)
        self._program.editor.set_diagnostics(shown, meaning)
        self._layout.show_counts(
            {**analysis.counts, PROBLEMS.name: len(shown) + len(analysis.in_files)}
        )

    def _show_known(self) -> None:
        """Show all that is wrong, if that is known."""
        analysis = self._program.analysis
        if analysis is not None:
            self._show_diagnostics(analysis)
            self.refresh()

    def edited(self) -> None:
        """Ask what the text means, as soon as no key comes; hold back what is half written."""
        self.worker.interrupt()
        self.held_back.edited()
        self.ask_soon()

    def moved(self) -> None:
        """Let the panels follow the cursor."""
        self.held_back.moved()
        self.refresh()

    def refresh(self) -> None:
        """Show what is known in the panels in sight, and ask for the rest."""
        self.ask_more()
        analysis = self._program.analysis
        if analysis is None:
            return
        offset = self._program.editor.cursor_offset
        for panel in self._fed():
            view = self._view_of(panel)
            request = Request(panel.name, view.request(analysis, offset))
            if request.what is None or request in analysis.made:
                made = analysis.made.get(request)
                if panel is PROBLEMS and isinstance(made, Entries):
                    made = self._without_held(analysis, made)
                view.show(made)
            if self._layout.is_in_sight(panel.name):
                view.follow(offset)

    def _without_held(self, analysis: Analysis, entries: Entries) -> Entries:
        """Return the problems without those that are held back; the same again for the same."""
        held = self.held_back.of(analysis.diagnostics)
        if not held:
            return entries
        known = self._unheld
        if known is None or known[0] is not entries or known[1] != held:
            from ..panels.problems import without

            known = self._unheld = (entries, held, without(entries, held))
        return known[2]

    def clear(self) -> None:
        """Show nothing, because another program is there."""
        self.held_back.clear()
        for view in self._widgets.made.values():
            if isinstance(view, ProgramView):
                view.show(None)
        self._layout.show_counts({})


def _has_first_robot(before: Analysis | None, now: Analysis) -> bool:
    """Tell whether a program begins to describe a robot, and has nothing else to show."""
    known = before is not None and bool(before.workspace.robots)
    return bool(now.workspace.robots) and not known and not now.workspace.nodes
