"""The live panel's monitors: what they say is shown, and what is asked of nodes goes to them."""

from __future__ import annotations

import itertools
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from time import monotonic
from typing import TYPE_CHECKING, Any

from textual.screen import Screen

from plastron_tui.diagnostics import Edit, Span
from plastron_tui.diagnostics.terminal import visible
from plastron_tui.regular_files import reason
from plastron_tui.runtime.live_graph import LiveGraph, NodeEnd

from ..delay import Delay
from ..key_order import InOrder
from ..panels.live_panel import LOOKING, NOTHING_RUNS, STARTING, LivePanel
from ..panels.live_row import Answer, Kind, LiveRow
from ..panels.live_watching import Watching
from .active_program import ActiveProgram, Tab
from .workers import start_exclusive

if TYPE_CHECKING:
    from plastron_tui.runtime.monitor import Monitor, MonitorCommand

    from ..wizard.live_form import LiveForm
    from ..wizard.values import Path

_SHOWN_AFTER = 0.1
"""Seconds for which what monitors say is gathered: the eye needs no more, and keys come first."""
_TYPING = 0.3
"""Seconds without a key after which nobody types."""
_SHOWN_TYPING = 1.0
"""Seconds for which it is gathered while somebody types: no key is to wait for a table."""
_LOOK = 2.0
"""Seconds after which is looked again whether a monitor hangs."""


class LiveActions:
    """Starts and ends the monitors of the nodes that run.

    Attributes:
        on_written: called when the program has got a value that a node was given.
    """

    def __init__(self, screen: Screen[None], panel: LivePanel, program: ActiveProgram) -> None:
        """Start with nothing that runs.

        Args:
            screen: shows dialogs.
            panel: shows what is known.
            program: what is in front.
        """
        self._screen = screen
        self._program = program
        self.on_written: Callable[[], object] = lambda: None
        self._tab: Tab | None = None
        self._panel = panel
        panel.on_watched, panel.on_asked = self.update_subscriptions, self.run_order
        self._delay = Delay(screen, self._show)
        self._shown_at = 0.0
        self._is_in_sight = False
        self._look = Delay(screen, self._look_at_monitors)
        self._commands: Sequence[MonitorCommand] = ()
        self._monitors: dict[int, Monitor] = {}
        self._graphs: dict[int, LiveGraph] = {}
        self._watching: dict[int, Watching] = {}
        self._silent: set[int] = set()
        self._retried: set[int] = set()
        """Those whose monitor was started again by itself."""
        self._numbers = itertools.count(1)
        self._asked: dict[int, tuple[LiveRow, LiveForm | None]] = {}
        self._answers: dict[str, Answer] = {}
        self._said: Counter[str] = Counter()
        self._given: dict[str, dict[Path, str]] = {}
        self._empty = NOTHING_RUNS

    def starting(self) -> None:
        """Show that nodes are about to run, and nothing of those before."""
        self.end()
        self._graphs, self._answers, self._commands = {}, {}, ()
        self._asked.clear()
        self._said.clear()
        self._tell(STARTING)

    def preparing(self, step: str) -> None:
        """Say what is done before the nodes start: to compile them takes its time."""
        self._tell(f"{visible(step)}\nthe nodes start then, and what they send is shown here")

    def start(self, tab: Tab, commands: Sequence[MonitorCommand]) -> None:
        """Watch nodes.

        Args:
            tab: whose nodes they are, whichever is in front; its types are those of the forms.
            commands: what starts their monitors.
        """
        if tab is not self._tab:
            # A topic of that name may have another type there.
            self._given.clear()
        self._tab, self._commands = tab, commands
        self._retried.clear()
        self._close()
        self._tell(LOOKING)
        self._start_missing()

    def _start_missing(self) -> None:
        """Start the monitors that do not run."""
        from plastron_tui.runtime.monitor import Monitor

        for each in self._commands:
            if each.ros_version in self._monitors:
                continue
            graph = self._graphs.setdefault(each.ros_version, LiveGraph(each.ros_version))
            graph.domain = each.environ.get("ROS_DOMAIN_ID", "0") if each.ros_version == 2 else "0"
            graph.own = frozenset(itertools.chain.from_iterable(each.nodes.values()))
            try:
                self._monitors[each.ros_version] = Monitor(each, self._news)
            except OSError as error:
                self._fail(each.ros_version, f"the nodes cannot be watched: {reason(error)}")
        self.update_subscriptions()
        self._look.start(_LOOK)

    def end(self) -> None:
        """Watch no more: the nodes have ended. What was seen last stays."""
        self._commands = ()
        self._close()
        for graph in self._graphs.values():
            graph.end()
        self._tell(NOTHING_RUNS)

    def close(self) -> None:
        """End the monitors, because the studio ends."""
        self._close()

    def _close(self) -> None:
        for monitor in self._monitors.values():
            monitor.close()
        for graph in self._graphs.values():
            graph.drop_orders()
        self._monitors, self._watching, self._silent = {}, {}, set()
        self._delay.stop()
        self._look.stop()

    def update_subscriptions(self) -> None:
        """Have the topics and nodes in sight listened to, and no others."""
        self._say_what_goes_on()
        for version, monitor in self._monitors.items():
            wanted = self._panel.watching(version)
            if self._watching.get(version) != wanted:
                self._watching[version] = wanted
                monitor.order(
                    do="watch", topics=wanted.topics, full=wanted.full, nodes=wanted.nodes
                )

    def _say_what_goes_on(self) -> None:
        """Say once what is still sent where its row goes out of sight: it may move a robot."""
        sent = [each for graph in self._graphs.values() for each in graph.sendings]
        was_in_sight, self._is_in_sight = self._is_in_sight, self._panel.is_in_sight
        if sent and was_in_sight and not self._is_in_sight:
            self._say(f"still sending to {', '.join(sent)}; x in Live ends it")

    def show_soon(self) -> None:
        """Show what monitors say, soon: all that comes until then at once."""
        if not self._delay.is_waiting:
            self._delay.start(_SHOWN_AFTER)

    def _news(self) -> None:
        """Show it soon; called from a thread that reads."""
        self._screen.call_later(self.show_soon)

    @property
    def _is_held_back(self) -> bool:
        """Whether somebody types, and has seen what is known a moment ago."""
        app = self._screen.app
        is_typing = isinstance(app, InOrder) and app.since_typed < _TYPING
        is_recent = monotonic() - self._shown_at < _SHOWN_TYPING
        return is_typing and is_recent and app.screen is self._screen

    def _show(self) -> None:
        if self._is_held_back:
            self._delay.start(_SHOWN_AFTER)
            return
        self._shown_at = monotonic()
        is_new = False
        for version, monitor in list(self._monitors.items()):
            graph = self._graphs[version]
            for report in monitor.take():
                if report.get("tell") == "answer":
                    is_new |= self._take_answer(report)
                elif report.get("tell") == "goal":
                    # It is shown there, and answered only where it could not be sent.
                    self._asked.pop(report.get("id", 0), None)
                    is_new |= graph.feed(report)
                else:
                    is_new |= graph.feed(report)
            if monitor.ended is not None:
                self._lost(version, f"the monitor has ended: {monitor.ended}")
                is_new = False
        if is_new:
            self._tell(self._empty, unseen=False)
        self.update_subscriptions()

    def _tell(self, empty: str, *, unseen: bool = True) -> None:
        self._empty = empty
        graphs = [graph for graph in self._graphs.values() if graph.is_known or graph.problem]
        self._panel.show_live(graphs, self._answers, empty, unseen=unseen)

    def _look_at_monitors(self) -> None:
        for version, monitor in list(self._monitors.items()):
            if not monitor.is_silent:
                self._silent.discard(version)
            elif version not in self._silent:
                # The studio itself may have been stopped, and what was said not be read yet.
                self._silent.add(version)
            else:
                monitor.kill()
                self._lost(version, "the monitor of the nodes did not answer any more")
        if self._monitors:
            self._look.start(_LOOK)

    def mark_ended(self, ends: Mapping[str, NodeEnd]) -> None:
        """Mark nodes that have ended by themselves: the middleware believes in them for longer.

        Args:
            ends: how they have ended, by what their lines are labelled with.
        """
        is_new = False
        for command in self._commands:
            graph = self._graphs[command.ros_version]
            for label, end in ends.items():
                is_new |= graph.mark_ended(command.nodes.get(label, ()), end)
        if is_new:
            self._tell(self._empty)

    def _lost(self, version: int, why: str) -> None:
        """Watch again, once; then say that a monitor is no more. The nodes run on."""
        monitor = self._monitors.pop(version)
        monitor.close()
        self._watching.pop(version, None)
        self._silent.discard(version)
        if version not in self._retried:
            self._retried.add(version)
            self._fail(version, f"not watched for the moment: {why}")
            self._start_missing()
            return
        self._fail(version, f"not watched, press R to watch again: {why}")
        text = f"the nodes run on, but are not watched: {visible(why)}"
        self._screen.notify(text, severity="warning", markup=False)

    def _fail(self, version: int, problem: str) -> None:
        graph = self._graphs[version]
        graph.problem = problem
        graph.lose_monitor()
        self._tell(self._empty)

    def run_order(self, what: str, row: LiveRow | None) -> None:
        """Start monitors again, or ask for what is sent about a row: see `LivePanel.on_asked`."""
        if what == "restart":
            self._retried.clear()
            self._start_missing()
        elif what == "cancel" and row is not None:
            self._cancel(row)
        elif row is not None:
            start_exclusive(self._screen, "live", self._ask, row)

    def _cancel(self, row: LiveRow) -> None:
        """Send to a topic no more, or cancel a goal; what comes of it is shown there."""
        monitor = self._monitors.get(row.ros_version)
        if monitor is None:
            return
        if row.kind is Kind.TOPIC:
            monitor.order(do="stop", name=row.owner)
        else:
            monitor.order(do="cancel", goal=row.goal)

    async def _ask(self, row: LiveRow) -> None:
        if row.ros_version not in self._monitors or self._tab is None:
            self._say("nothing runs that could take it")
            return
        from ..wizard.live_orders import form_for

        topic = self._graphs[row.ros_version].topics.get(row.owner)
        seen = () if topic is None or row.kind is not Kind.TOPIC else topic.fields
        form = form_for(row, self._tab.open.session, self._given.get(row.key, {}), seen)
        if isinstance(form, str):
            self._say(form)
            return
        dialog = form.dialog
        if row.kind is Kind.PARAMETER:
            # A node may refuse a value that fits: what was typed is still there then.
            dialog.ask = lambda given: self._order(row, form.order(given), dialog)
            if self._default_span(row) is not None:
                dialog.other_verb = "Set, and write it into the program"
            set_to = await self._screen.app.push_screen_wait(dialog)
            if set_to is not None and dialog.is_other:
                self._write_default(row, set_to)
            return
        given = await self._screen.app.push_screen_wait(dialog)
        if given is None:
            return
        # A parameter has a value, which is what its form begins with; this begins with the last.
        self._given[row.key] = given
        if not self._order(row, form.order(given)):
            self._say("the monitor of the nodes takes nothing any more")

    def _default_span(self, row: LiveRow) -> Span | None:
        """Return where the program in front says what a parameter is, None for nowhere."""
        from ..parameter_default import default_span

        analysis, parameter = self._program.analysis, row.parameter
        if analysis is None or parameter is None:
            return None
        return default_span(analysis, row.owner, parameter.name)

    def _write_default(self, row: LiveRow, given: Mapping[Path, str]) -> None:
        """Let a parameter begin with the value that it was just given."""
        from ..wizard.live_orders import default_text

        span = self._default_span(row)
        text = None if row.parameter is None else default_text(row.parameter, given)
        if span is None or text is None:
            self._say("the program cannot have this value; the node has it until it ends")
            return
        self._program.editor.apply([Edit(span, text)])
        self.on_written()
        self._say(f"the program begins with {row.name} {text} now")

    def _order(self, row: LiveRow, order: Mapping[str, Any], form: LiveForm | None = None) -> bool:
        """Tell a monitor what to do; tell whether it takes orders.

        Args:
            row: what it is about.
            order: what to do.
            form: the form that waits for the answer.
        """
        monitor = self._monitors.get(row.ros_version)
        number = next(self._numbers)
        if monitor is None or not monitor.order(id=number, **order):
            return False
        self._asked[number] = row, form
        return True

    def _take_answer(self, report: Any) -> bool:
        row, form = self._asked.pop(report.get("id", 0), (None, None))
        if row is None:
            return False
        is_failure, text = bool(report.get("is_failure")), str(report.get("text"))
        if form is not None and form.is_current:
            form.answered(text, is_failure=is_failure)
            if is_failure:
                return False
        if row.kind is Kind.SERVICE:
            self._answers[row.key] = Answer(text, is_failure)
            return True
        if not text:
            # It is shown there.
            return False
        severity = "warning" if is_failure else "information"
        words = f"{row.name}: {visible(text)}" if row.kind is Kind.PARAMETER else visible(text)
        # Notes that are the same are shown once, and who sends twice wants to know of both.
        self._said[words] += 1
        if self._said[words] > 1:
            words += f" ({self._said[words]})"
        self._screen.notify(words, severity=severity, markup=False, timeout=3)  # type: ignore[arg-type]
        return False

    def _say(self, text: str) -> None:
        self._screen.notify(visible(text), timeout=3, markup=False)
