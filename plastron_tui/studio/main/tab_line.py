"""The line of tabs: the programs that are open, where there is more than one."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import ClassVar, NamedTuple

from rich.cells import cell_len, set_cell_size
from rich.segment import Segment
from rich.style import Style
from textual import events
from textual.message import Message
from textual.strip import Strip

from plastron_tui.diagnostics.terminal import visible

from ..cells import end_of
from ..files import SUFFIX
from ..open_program import Open
from ..panels.styles import Toned
from .active_program import ActiveProgram, Tab

_WIDEST = 24
"""The most cells of a name."""


class Label(NamedTuple):
    """What a tab says: a name, then signs for what is not saved and for nodes that run."""

    name: str
    is_changed: bool = False
    runs: bool = False

    @property
    def text(self) -> str:
        """The tab as it is drawn."""
        signs = f"{'●' if self.is_changed else ''}{'▶' if self.runs else ''}"
        return f" {self.name} {signs} " if signs else f" {self.name} "


def names_of(programs: Sequence[Open]) -> list[str]:
    """Return what tabs call programs: no two alike.

    Files of the same name have folders before it, those that are alike even so a number behind it.
    """
    short = [_short_name(open_.name) for open_ in programs]
    names = [
        end_of(_in_folders(open_, name, programs) if short.count(name) > 1 else name, _WIDEST)
        for open_, name in zip(programs, short, strict=True)
    ]
    times = Counter[str]()
    for at, name in enumerate(names):
        times[name] += 1
        if times[name] > 1:
            names[at] = f"{name} {times[name]}"
    return names


def _short_name(name: str) -> str:
    return visible(name.removesuffix(SUFFIX) or name)


def _in_folders(open_: Open, name: str, programs: Sequence[Open]) -> str:
    """Return a name with the fewest folders before it that tell a file from others of its name."""
    if open_.path is None:
        return name
    folders = _folders(open_.path)
    rivals = [
        _folders(other.path)
        for other in programs
        if other is not open_ and other.path is not None and other.path.name == open_.path.name
    ]
    count = 1
    while count < len(folders) and any(rival[:count] == folders[:count] for rival in rivals):
        count += 1
    *inner, outer = map(visible, folders[:count])
    shown = "/".join([outer, *reversed(inner), name])
    return shown if cell_len(shown) <= _WIDEST or not inner else f"{outer}/…/{name}"


def _folders(path: Path) -> tuple[str, ...]:
    """Return the names of the folders that a file is in, the innermost first."""
    return tuple(each.name for each in path.absolute().parents)


def window_of(widths: Sequence[int], active: int, room: int) -> tuple[int, int]:
    """Return the first tab that is drawn and the one behind the last: the active one is there.

    Args:
        widths: the cells of each tab.
        active: the number of the one in front.
        room: the cells for all.
    """
    first, end, used = active, active + 1, widths[active]
    while True:
        if end < len(widths) and used + widths[end] <= room:
            used += widths[end]
            end += 1
        elif first > 0 and used + widths[first - 1] <= room:
            first -= 1
            used += widths[first]
        else:
            return first, end


class TabLine(Toned):
    """Draws the tabs, and tells which one the mouse picks."""

    COMPONENT_CLASSES: ClassVar[set[str]] = {"tab-line--active"}

    class Picked(Message):
        """A tab was clicked on; with the middle button it is to be closed."""

        def __init__(self, number: int, *, closes: bool) -> None:
            super().__init__()
            self.number = number
            self.closes = closes

    def __init__(self, *, id: str) -> None:  # noqa: A002 - Textual's word
        super().__init__(id=id)
        self.labels: tuple[Label, ...] = ()
        self.active = 0
        self.display = False

    def show(self, labels: Sequence[Label], active: int) -> None:
        """Show tabs, where there are several; `active` is the number of the one in front."""
        if (tuple(labels), active) != (self.labels, self.active):
            self.labels, self.active = tuple(labels), active
            self.display = len(labels) > 1
            self.refresh()

    def show_programs(self, program: ActiveProgram, runs_in: Callable[[Tab], bool]) -> None:
        """Show the programs that are open; `runs_in` tells where nodes run."""
        tabs = program.tabs
        if len(tabs) > 1 or self.display:
            names = names_of([tab.open for tab in tabs])
            labels = [
                Label(name, tab.open.is_changed, runs_in(tab))
                for name, tab in zip(names, tabs, strict=True)
            ]
            self.show(labels, tabs.index(program.tab))

    @property
    def text(self) -> str:
        """The tabs as they are drawn."""
        return self.render_line(0).text if self.display else ""

    def _places(self) -> list[tuple[int, int, int]]:
        """Return the number, the first cell and the width of each tab in sight."""
        widths = [cell_len(label.text) for label in self.labels]
        # At either side there may be a sign that there are more.
        first, end = window_of(widths, self.active, self.size.width - 2)
        places, at = [], 1
        for number in range(first, end):
            places.append((number, at, widths[number]))
            at += widths[number]
        return places

    def render_line(self, y: int) -> Strip:
        """Draw the tabs."""
        base = self.rich_style
        if not self.labels:
            return Strip.blank(self.size.width, base)
        places = self._places()
        segments = [Segment("‹" if places[0][0] else " ", base)]
        for number, _, width in places:
            style = base + self._style(number)
            segments.append(Segment(set_cell_size(self.labels[number].text, width), style))
        if places[-1][0] < len(self.labels) - 1:
            segments.append(Segment("›", base))
        return Strip(segments).adjust_cell_length(self.size.width, base)

    def _style(self, number: int) -> Style:
        return self.tone("active", "tab-line") if number == self.active else Style.null()

    def on_click(self, event: events.Click) -> None:
        """Tell which tab was picked."""
        for number, at, width in self._places():
            if at <= event.x < at + width:
                self.post_message(self.Picked(number, closes=event.button == 2))
