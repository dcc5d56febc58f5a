"""What travels between the nodes that run: topics, services, nodes and their parameters."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import takewhile
from time import monotonic
from typing import ClassVar

from textual import events
from textual.binding import Binding, BindingType
from textual.widget import Widget

from plastron_tui.runtime.live_graph import LiveGraph

from .entry import Entries, Entry
from .entry_list import EntryList
from .filter_bar import FilterBar
from .live_columns import Columns, columns_of, line_of
from .live_row import Answer, Kind, LiveRow
from .live_row_places import (
    branch_at,
    cancelable_at,
    cancels_at,
    last_sent_at,
    stop_near,
    target_at,
)
from .live_rows import UNCOUNTED, found_rows, live_rows
from .live_watching import Watching, watching_of
from .row_drawing import RowDrawing
from .styles import Line

NOTHING_RUNS = "nothing runs\nF5 starts the nodes; here is then what they send"
STARTING = "the nodes start…\nwhat they send is shown here"
LOOKING = "looking for topics…\nwhat the nodes send is shown here"
NOTHING_FOUND = "nothing has these words in its name or type\n/ and Esc show all again"
_KINDS = {
    "publish": Kind.TOPIC,
    "call": Kind.SERVICE,
    "goal": Kind.ACTION,
    "set": Kind.PARAMETER,
}
_ENTERED = {
    Kind.SENDING: "publish",
    Kind.SERVICE: "call",
    Kind.ANSWER: "call",
    Kind.ACTION: "goal",
    Kind.GOAL: "goal",
    Kind.PARAMETER: "set",
}
"""What Enter asks for, at a row that does not unfold."""


def _asking(what: str, keys: str, title: str, tooltip: str) -> Binding:
    return Binding(keys, f"ask('{what}')", title, id=f"live.{what}", tooltip=tooltip)


_BINDINGS: list[BindingType] = [
    Binding(
        "enter",
        "choose",
        "Open",
        id="live.open",
        tooltip="Unfold it, call it, send it a goal or set it",
    ),
    Binding("right,l", "unfold", "Unfold", show=False, id="live.unfold"),
    Binding("left,h", "fold_back", "Fold", show=False, id="live.fold"),
    _asking("publish", "p", "Publish", "Send a message to the topic"),
    _asking("call", "c", "Call", "Call the service"),
    _asking("goal", "g", "Goal", "Send a goal to the action"),
    _asking("cancel", "x", "Stop sending", "Send to the topic no more, or cancel the goal"),
    _asking("set", "s", "Set", "Give the parameter another value"),
    _asking("restart", "r", "Watch again", "Start the monitor of the nodes again"),
    Binding(
        "slash",
        "filter",
        "Filter",
        id="live.filter",
        tooltip="Show only what has certain words in its name or type",
    ),
]


class LivePanel(EntryList):
    """A table of what runs. It only knows what it is shown, and tells what is in sight of that.

    Attributes:
        on_watched: called when other rows came in sight, or the panel itself did, or is no more.
        on_asked: called when something shall be done about a row: `publish`, `call`, `goal`,
            `set` or `cancel`; or `restart`, whatever the row is.
    """

    BINDINGS: ClassVar[list[BindingType]] = _BINDINGS

    def __init__(self, *, id: str | None = None) -> None:  # noqa: A002 - Textual's word
        super().__init__(id=id, empty=NOTHING_RUNS)
        self.on_watched: Callable[[], None] = lambda: None
        self.on_asked: Callable[[str, LiveRow | None], None] = lambda _, __: None
        self._graphs: Sequence[LiveGraph] = ()
        self._answers: Mapping[str, Answer] = {}
        self._empty = NOTHING_RUNS
        self._live: list[LiveRow] = []
        self._unfolded: set[str] = set()
        self._words: tuple[str, ...] = ()
        self._bar: FilterBar | None = None
        self._has_moved = False
        """Whether somebody chose the row that the cursor is on."""
        self._columns = Columns(0, 0, 0, 0, 0)
        self._drawing = RowDrawing(self)

    @property
    def row(self) -> LiveRow | None:
        """The row that the cursor is on."""
        return self._live[self.index] if 0 <= self.index < len(self._live) else None

    @property
    def lines(self) -> list[str]:
        """The rows as they are drawn, without their colours."""
        width = self.scrollable_content_region.width
        drawn = (line_of(row, self._columns, width) for row in self._live)
        return ["".join(piece.text for piece in line).rstrip() for line in drawn]

    @property
    def is_in_sight(self) -> bool:
        """Whether somebody can look at it: what is told of that comes late, or not at all."""
        return self.is_attached and all(each.display for each in self.ancestors_with_self)

    def watching(self, version: int) -> Watching:
        """Return what is in sight of a generation of ROS."""
        if not self.is_in_sight:
            return Watching()
        top = int(self.scroll_offset.y)
        in_sight = range(top, top + max(1, self.size.height))
        return watching_of(self._live, in_sight, version, self._unfolded, self.row)

    def show_live(
        self,
        graphs: Sequence[LiveGraph],
        answers: Mapping[str, Answer],
        empty: str,
        *,
        unseen: bool = False,
    ) -> None:
        """Show what is known of what runs.

        Args:
            graphs: what is known, of each generation of ROS.
            answers: the last answers of services, by the key of their rows.
            empty: what is said where nothing is known.
            unseen: whether it is made ready though nobody sees it: a panel that comes back before
                it was drawn without is not told that it was away.
        """
        self._graphs, self._answers, self._empty = graphs, answers, empty
        if unseen or self.is_in_sight:
            self._show_rows()

    def _show_rows(self) -> None:
        rows = live_rows(self._graphs, self._unfolded, self._answers, monotonic())
        empty = NOTHING_FOUND if rows and self._words else self._empty
        if self._bar is not None:
            there = sum(row.depth == 0 and row.kind not in UNCOUNTED for row in rows)
            rows, found = found_rows(rows, self._words)
            self._bar.say(found, there)
        before, self._live = self._live, rows
        had_below = last_sent_at(before, self.index) - self.index
        old_columns = self._columns
        self._columns = columns_of(rows, self.scrollable_content_region.width)
        same = [row.key for row in before] == [row.key for row in rows]
        if not same or empty != self.entries.empty:
            self.show(Entries(map(_entry, rows), empty))
            self._has_moved &= bool(rows)
            if not self._has_moved:
                # What comes later may stand above what was there.
                self.index = 0
            elif (last := last_sent_at(rows, self.index)) - self.index > had_below:
                # Who has sent it looks for what comes of it.
                self._reveal(last)
            self.on_watched()
            self.refresh_bindings()
        elif self._columns != old_columns:
            self.refresh()
        else:
            pairs = list(zip(before, rows, strict=True))
            self._drawing.refresh(at for at, (old, new) in enumerate(pairs) if old != new)
            if any(_is_active(old) != _is_active(new) for old, new in pairs):
                self.refresh_bindings()

    async def action_filter(self) -> None:
        """Ask for the words that names or types have to have."""
        if self._bar is None:
            self._bar = FilterBar("live", "a name, or a type", self._find, self.focus)
            assert isinstance(self.parent, Widget)
            await self.parent.mount(self._bar)
        self._bar.ask()
        self._show_rows()

    def _find(self, words: tuple[str, ...]) -> None:
        self._words = words
        self._show_rows()

    def on_show(self) -> None:
        """Show what came meanwhile."""
        self._look()

    def on_focus(self) -> None:
        """Show it also where it was out of sight only for a moment, of which nothing is told."""
        self._look()

    def on_hide(self) -> None:
        """Tell that nobody looks any more."""
        self._look()

    def _look(self) -> None:
        if self._bar is not None:
            self._bar.display = self.display and bool(self._words)
        if self.is_in_sight:
            self._show_rows()
        self.on_watched()

    def on_resize(self) -> None:
        """Lay the columns out anew."""
        self._columns = columns_of(self._live, self.scrollable_content_region.width)
        self.refresh()
        self.on_watched()

    def watch_scroll_y(self, old_value: float, new_value: float) -> None:
        """Tell that other rows are in sight."""
        super().watch_scroll_y(old_value, new_value)
        if round(old_value) != round(new_value):
            self.on_watched()

    def validate_index(self, index: int) -> int:
        """Go on to the next row where one is a heading, in the direction that was taken."""
        return stop_near(self._live, index, self.index)

    def action_move(self, by: int) -> None:
        """Move the cursor; what stands above the first row that it goes to is seen too."""
        self._has_moved = True
        super().action_move(by)
        if all(row.kind is Kind.HEADING for row in self._live[: self.index]):
            self._reveal(0)

    def on_click(self, event: events.Click) -> None:
        """Choose the row under the mouse; a heading is none."""
        self._has_moved = True
        row = event.y + self.scroll_offset.y
        if row < len(self._live) and self._live[row].kind is not Kind.HEADING:
            super().on_click(event)

    def watch_index(self, old: int, new: int) -> None:
        """Offer other actions with another row."""
        super().watch_index(old, new)
        self.on_watched()
        if self.has_focus:
            self.refresh_bindings()

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """Offer what can be done about the row under the cursor."""
        if action == "choose":
            is_asked = _is_asked_about(self._graphs, self.row)
            return is_asked or branch_at(self._live, self.index) is not None
        if action != "ask":
            return True
        if parameters[0] == "restart":
            return any(graph.problem for graph in self._graphs)
        return self._target(str(parameters[0])) is not None

    @property
    def key_titles(self) -> dict[str, str]:
        """What its keys are called in the line of keys, where that hangs on the row."""
        return {"live.cancel": cancels_at(self._live, self.index)}

    def _target(self, what: str) -> LiveRow | None:
        """Return the row that something is asked for about, None where there is none."""
        return _target_at(self._live, self.index, what, self._graphs)

    def action_ask(self, what: str) -> None:
        """Ask for something to be done."""
        self._has_moved = True
        self.on_asked(what, self._target(what))

    def action_choose(self) -> None:
        """Unfold the row, or fold it; ask for what a row is there for that does not unfold."""
        row = self.row
        if row is not None and row.kind in _ENTERED:
            self.action_ask(_ENTERED[row.kind])
        else:
            self.action_fold()

    def action_fold(self) -> None:
        """Fold or unfold the row, or the one that it belongs to."""
        at = branch_at(self._live, self.index)
        if at is not None:
            self._toggle(at)

    def action_unfold(self) -> None:
        """Unfold the row."""
        row = self.row
        if row is not None and row.is_branch and not row.is_open:
            self._toggle(self.index)

    def action_fold_back(self) -> None:
        """Fold the row, or the one that it belongs to."""
        at = branch_at(self._live, self.index)
        if at is not None and self._live[at].is_open:
            self._toggle(at)

    def _toggle(self, at: int) -> None:
        self._has_moved = True
        self._unfolded ^= {self._live[at].key}
        self.index = at
        self._show_rows()
        below = takewhile(lambda row: row.depth, self._live[at + 1 :])
        self._reveal(at + sum(1 for _ in below))
        self._reveal(at)

    def _line(self, entry: Entry, width: int) -> Line:
        return line_of(self._live[self._rows[entry.key]], self._columns, width)


def _target_at(
    rows: Sequence[LiveRow], at: int, what: str, graphs: Sequence[LiveGraph]
) -> LiveRow | None:
    if what == "cancel":
        return cancelable_at(rows, at)
    kind = _KINDS.get(what)
    found = None if kind is None else target_at(rows, at, kind)
    return None if found is None or _has_ended(graphs, found) else found


def _has_ended(graphs: Sequence[LiveGraph], row: LiveRow) -> bool:
    """Tell whether a row is about nodes that were ended, and nobody can be asked any more."""
    return any(graph.has_ended and graph.ros_version == row.ros_version for graph in graphs)


def _is_asked_about(graphs: Sequence[LiveGraph], row: LiveRow | None) -> bool:
    """Tell whether Enter asks for something to be done about a row."""
    return row is not None and row.kind in _ENTERED and not _has_ended(graphs, row)


def _is_active(row: LiveRow) -> bool:
    return row.is_sent_to or bool(row.goal)


def _entry(row: LiveRow) -> Entry:
    return Entry(row.key, row.name, is_branch=row.is_branch, depth=row.depth)
