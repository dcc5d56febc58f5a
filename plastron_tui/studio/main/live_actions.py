"""The live panel's monitors: what they say is shown, and what is asked of nodes goes to them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from itertools import chain, count, product
from time import monotonic
from typing import TYPE_CHECKING, Any

from textual.screen import Screen

from plastron_tui.diagnostics.terminal import visible
from plastron_tui.regular_files import reason
from plastron_tui.runtime.live_graph import LiveGraph, LiveTopic, NodeEnd

from ..delay import Delay
from ..key_order import InOrder
from ..panels.live_panel import LOOKING, NOTHING_RUNS, STARTING, LivePanel
from ..panels.live_row import Answer, Kind, LiveRow
from ..panels.live_row_places import field_of
from ..panels.live_watching import Watching
from .active_program import ActiveProgram
from .live_defaults import default_place, write_default
from .workers import start_exclusive

if TYPE_CHECKING:
    from plastron_tui.runtime.monitor import Monitor, MonitorCommand
    from plastron_tui.session import Session

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
        self._sessions: Sequence[Session] = ()
        self._panel = panel
        panel.on_watched, panel.on_asked = self.update_subscriptions, self.run_order
        self._delay = Delay(screen, self._show)
        self._shown_at = 0.0
        self._is_due = False
        self._is_in_sight = False
        self._look = Delay(screen, self._look_at_monitors)
        self._commands: Sequence[MonitorCommand] = ()
        self._own: Mapping[int, frozenset[str]] | None = None
        self._monitors: dict[int, Monitor] = {}
        self._graphs: dict[int, LiveGraph] = {}
        self._watching: dict[int, Watching] = {}
        self._silent: set[int] = set()
        self._retried: set[int] = set()
        """Those whose monitor was started again by itself."""
        self._numbers = count(1)
        self._asked: dict[int, tuple[LiveRow, LiveForm | None]] = {}
        self._answers: dict[str, Answer] = {}
        self._said: Counter[str] = Counter()
        self._given: dict[str, dict[Path, str]] = {}
        self._edited: dict[str, Path] = {}
        self._empty = NOTHING_RUNS

    def starting(self) -> None:
        """Show that nodes are about to run, and nothing of those before."""
        self.end()
        self._graphs, self._answers, self._commands = {}, {}, ()
        self._said.clear()
        self._tell(STARTING)

    def forget_ends(self, commands: Sequence[MonitorCommand]) -> None:
        """Note that the nodes of a run start again, however they have ended before."""
        for graph, command in product(self._graphs.values(), commands):
            graph.forget_ends(chain.from_iterable(command.nodes.values()))

    def preparing(self, step: str) -> None:
        """Say what is done before the nodes start: to compile them takes its time."""
        self._tell(f"{visible(step)}\nthe nodes start then, and what they send is shown here")

    def watch(self, commands: Sequence[MonitorCommand]) -> None:
        """Watch nodes; a monitor that runs, and knows the types of all of them, goes on.

        Args:
            commands: what starts their monitors.
        """
        kept = {each.ros_version for each in commands if each in self._commands}
        for version in self._monitors.keys() - kept:
            self._close(version)
        self._commands = commands
        self._retried.clear()
        if not any(graph.is_known for graph in self._graphs.values()):
            self._tell(LOOKING)
        self._start_missing()

    def follow(self, own: Mapping[int, frozenset[str]] | None, sessions: Sequence[Session]) -> None:
        """Follow the program in front.

        Args:
            own: its nodes that run, or ran last, by the generation of ROS; None where nobody said.
            sessions: it, and the program whose nodes were started last: the forms take their types.
        """
        self._sessions, self._own = sessions, own
        before = [graph.own for graph in self._graphs.values()]
        for graph in self._graphs.values():
            graph.own = self._own_of(graph)
        if before != [graph.own for graph in self._graphs.values()]:
            self._tell(self._empty)

    def _own_of(self, graph: LiveGraph) -> frozenset[str] | None:
        return None if self._own is None else self._own.get(graph.ros_version, frozenset())

    def _start_missing(self) -> None:
        """Start the monitors that do not run."""
        from plastron_tui.runtime.monitor import Monitor

        for each in self._commands:
            if each.ros_version in self._monitors:
                continue
            graph = self._graphs.setdefault(each.ros_version, LiveGraph(each.ros_version))
            graph.domain = each.environ.get("ROS_DOMAIN_ID", "0") if each.ros_version == 2 else "0"
            graph.own = self._own_of(graph)
            try:
                self._monitors[each.ros_version] = Monitor(each, self._news)
            except OSError as error:
                self._fail(each.ros_version, f"the nodes cannot be watched: {reason(error)}")
        self.update_subscriptions()
        self._look.start(_LOOK)

    def end(self) -> None:
        """Watch no more: the nodes have ended. What was seen last stays."""
        self._commands = ()
        self._close_all()
        for graph in self._graphs.values():
            graph.end()
        self._tell(NOTHING_RUNS)

    def close(self) -> None:
        """End the monitors, because the studio ends."""
        self._close_all()

    def _close_all(self) -> None:
        for version in list(self._monitors):
            self._close(version)
        self._delay.stop()
        self._look.stop()

    def _close(self, version: int) -> None:
        monitor = self._monitors.pop(version, None)
        if monitor is not None:
            monitor.close()
            self._graphs[version].drop_orders()
            self._drop_asked(version)
        self._watching.pop(version, None)
        self._silent.discard(version)

    def topic(self, name: str) -> LiveTopic | None:
        """Return what is known of a topic, None of one that is not listened to now."""
        for version, watching in self._watching.items():
            if name in watching.topics:
                return self._graphs[version].topics.get(name)
        return None

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
        known = [each for graph in self._graphs.values() for each in graph.sendings.items()]
        sent = [name for name, sending in known if not sending.problem]
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
        is_new, self._is_due = self._is_due, False
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
        graphs = [graph for graph in self._graphs.values() if graph.is_shown]
        self._panel.show_live(graphs, self._answers, empty, unseen=unseen)

    def _look_at_monitors(self) -> None:
        if any(graph.gone_since for graph in self._graphs.values()):
            # What is not of the program goes some seconds after it was missed.
            self._is_due = True
            self.show_soon()
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

    def mark_ended(self, commands: Sequence[MonitorCommand], ends: Mapping[str, NodeEnd]) -> None:
        """Mark nodes that have ended by themselves: the middleware believes in them for longer.

        Args:
            commands: what starts monitors of their run.
            ends: how they have ended, by what their lines are labelled with.
        """
        is_new = False
        for command in commands:
            graph = self._graphs.get(command.ros_version, LiveGraph(command.ros_version))
            for label, end in ends.items():
                is_new |= graph.mark_ended(command.nodes.get(label, ()), end)
        if is_new:
            self._tell(self._empty)

    def _lost(self, version: int, why: str) -> None:
        """Watch again, once; then say that a monitor is no more. The nodes run on."""
        self._close(version)
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
        if row.ros_version not in self._monitors or not self._sessions:
            self._say("nothing runs that could take it")
            return
        from ..wizard.live_orders import form_for

        topic = self._graphs[row.ros_version].topics.get(row.owner)
        seen = () if topic is None or row.kind is not Kind.TOPIC else topic.fields
        # A topic of that name may have another type in another program.
        about = f"{row.key} {row.type}"
        given, edited = self._given.get(about, {}), self._edited.get(about, ())
        at = field_of(self._panel.row, row)
        forms = [form_for(row, session, given, seen, at, edited) for session in self._sessions]
        form = next((each for each in forms if not isinstance(each, str)), forms[0])
        if isinstance(form, str):
            self._say(form)
            return
        dialog = form.dialog
        if row.kind is Kind.PARAMETER:
            # A node may refuse a value that fits: what was typed is still there then.
            dialog.ask = lambda given: self._order(row, form.order(given), dialog)
            if default_place(self._program, row) is not None:
                dialog.other_verb = "Set, and write it into the program"
        entered = await self._screen.app.push_screen_wait(dialog)
        if entered is None:
            return
        if row.kind is Kind.PARAMETER:
            if dialog.is_other:
                self._say(write_default(self._program, row, entered, self.on_written))
            return
        # A parameter has a value, which is what its form begins with; this begins with the last.
        self._given[about], self._edited[about] = entered, dialog.edited or edited
        if not self._order(row, form.order(entered)):
            self._say("the monitor of the nodes takes nothing any more")

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

    def _drop_asked(self, version: int) -> None:
        """Wait for no answer any more of a generation of ROS; forms are told."""
        for number, (row, form) in list(self._asked.items()):
            if version == row.ros_version:
                del self._asked[number]
                if form is not None and form.is_current:
                    form.answered("nobody answered: try again", is_failure=True)

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
        if row.kind is Kind.SERVICE or not text:  # it is shown there
            return row.kind is Kind.SERVICE
        severity = "warning" if is_failure else "information"
        # Notes that are the same are shown once, and who sends twice wants to know of both.
        words = visible(text)
        self._said[words] += row.kind is not Kind.PARAMETER
        words += f" ({self._said[words]})" if self._said[words] > 1 else ""
        self._screen.notify(words, severity=severity, markup=False, timeout=3)  # type: ignore[arg-type]
        return False

    def _say(self, text: str) -> None:
        self._screen.notify(visible(text), timeout=3, markup=False)
