"""Docks: panels behind tabs, beside or below the editor, with an edge that can be dragged."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import ClassVar, NamedTuple

from rich.cells import cell_len
from rich.segment import Segment
from rich.style import Style
from textual import events
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Container, Vertical
from textual.message import Message
from textual.reactive import reactive
from textual.strip import Strip
from textual.widget import Widget

from .panel import Panel, PanelWidgets
from .styles import Toned

_PLAIN = Style.null()


class _Room(NamedTuple):
    """How tabs are written.

    Attributes:
        behind_name: what stands behind a name.
        behind_count: what stands behind a count.
        counted: whether `all`, the `active` one or only `alarms` are counted; alarms always are.
        shortened: how many of the names that can be are short, from the right.
        hides_empty: whether what is known to be empty has no tab.
    """

    behind_name: str = ""
    behind_count: str = ""
    counted: str = "alarms"
    shortened: int = 0
    hides_empty: bool = False


_TIGHTER = (
    _Room(" ", " ", "all"),
    _Room("", " ", "all"),
    _Room("", " ", "active"),
    _Room("", "", "active"),
    _Room(),
    *(_Room(shortened=count) for count in range(1, 5)),
    _Room(hides_empty=True),
    *(_Room(shortened=count, hides_empty=True) for count in range(1, 5)),
)
"""The ways in which tabs are written, the roomiest first."""


class TabStrip(Toned):
    """One line with the names of panels; it is the edge of its dock too."""

    COMPONENT_CLASSES: ClassVar[set[str]] = {
        "tab-strip--active",
        "tab-strip--count",
        "tab-strip--alarm",
        "tab-strip--rule",
    }

    corners: reactive[tuple[str, str]] = reactive(("", ""))
    """What the line begins and ends with, where it is the upper side of a frame."""

    class Picked(Message):
        """A tab was clicked."""

        def __init__(self, name: str) -> None:
            super().__init__()
            self.name = name

    class Dragged(Message):
        """The edge was dragged to a row of the screen."""

        def __init__(self, strip: TabStrip, row: int) -> None:
            super().__init__()
            self.strip = strip
            self.row = row

    def __init__(self) -> None:
        super().__init__()
        self.tabs: tuple[Panel, ...] = ()
        self.counts: Mapping[str, int] = {}
        self.active = ""
        self._places: list[tuple[int, int, str]] = []
        self._is_dragged = False
        self._pressed_at = 0

    def show(self, tabs: Iterable[Panel], active: str, counts: Mapping[str, int]) -> None:
        """Show the tabs of panels, with how much is in each."""
        new = (tuple(tabs), active, dict(counts))
        if new != (self.tabs, self.active, self.counts):
            self.tabs, self.active, self.counts = new
            self.refresh()

    def render_line(self, y: int) -> Strip:
        """Draw the line: as many tabs as fit, the active one always."""
        base = self.rich_style
        before, behind = self.corners
        width = max(0, self.size.width - len(before) - len(behind))
        tabs = self._fitting(width)
        sizes = [cell_len(text) + cell_len(count) for _, text, count in tabs]
        at = next((at for at, (panel, _, _) in enumerate(tabs) if panel.name == self.active), 0)
        first, mark = 0, int(at + 1 < len(tabs))
        while first < at and sum(sizes[first : at + 1]) + mark > width:
            first += 1
        rule = base + self.tone("rule", "tab-strip")
        segments, x = [Segment(before, rule)], 0
        lit = self.tone("active", "tab-strip")
        self._places = []
        for (panel, text, count), size in list(zip(tabs, sizes, strict=True))[first:]:
            is_active = panel.name == self.active
            style = base + (lit if is_active else _PLAIN)
            if first and not x:
                # There are tabs before this one.
                text = f"‹{text[1:]}"
            kind = "alarm" if panel.is_alarm else "count"
            if is_active and lit.reverse:
                # What is filled with a colour touches no other name, and its count is part of it.
                label = text + count
                name = label.strip()
                before_name, _, behind_name = label.partition(name)
                segments.append(Segment(before_name, base))
                segments.append(Segment(name, style))
                segments.append(Segment(behind_name, base))
            else:
                segments.append(Segment(text, style))
                segments.append(Segment(count, style + self.tone(kind, "tab-strip")))
            self._places.append((len(before) + x, len(before) + x + size, panel.name))
            x += size
        tabs_strip = Strip(segments).crop(0, len(before) + width)
        if x > width:
            tabs_strip = Strip([*tabs_strip.crop(0, len(before) + width - 1), Segment("›", base)])
        return Strip([*tabs_strip, Segment("─" * max(0, width - x) + behind, rule)])

    def _fitting(self, width: int) -> list[tuple[Panel, str, str]]:
        """Return the tabs, their text and count: with all counts and some room if that fits.

        Names are short where there is no room for them, and after that what is empty has no tab.
        """
        for room in _TIGHTER:
            tabs = list(self._written(room))
            if sum(cell_len(text) + cell_len(count) for _, text, count in tabs) <= width:
                break
        return tabs

    def _written(self, room: _Room) -> Iterator[tuple[Panel, str, str]]:
        """Yield the tabs, their text and count, as they are written in some room."""
        can_be_short = [panel.name for panel in self.tabs if panel.short]
        short = can_be_short[max(0, len(can_be_short) - room.shortened) :]
        for panel in self.tabs:
            is_active = panel.name == self.active
            known = self.counts.get(panel.name)
            if room.hides_empty and known == 0 and not (is_active or panel.is_alarm):
                continue
            is_counted = (
                panel.is_alarm or room.counted == "all" or (room.counted == "active" and is_active)
            )
            count = (known or 0) if is_counted else 0
            title = panel.short if panel.name in short else panel.title
            text = f" {title} " if count else f" {title}{room.behind_name}"
            yield panel, text, f"{count}{room.behind_count}" if count else ""

    def on_mouse_down(self, event: events.MouseDown) -> None:
        """Begin to drag the edge."""
        self._is_dragged = False
        self._pressed_at = int(event.screen_y)
        self.capture_mouse()
        event.stop()

    def on_mouse_move(self, event: events.MouseMove) -> None:
        """Drag the edge."""
        if self.app.mouse_captured is not self:
            return
        if self._is_dragged or int(event.screen_y) != self._pressed_at:
            self._is_dragged = True
            self.post_message(self.Dragged(self, int(event.screen_y)))

    def on_mouse_up(self, event: events.MouseUp) -> None:
        """Pick a tab, or let the edge go."""
        self.release_mouse()
        if not self._is_dragged:
            for start, end, name in self._places:
                if start <= event.x < end:
                    self.post_message(self.Picked(name))


class Edge(Toned):
    """The line between a dock and the editor, to drag; where there are frames, a side of one."""

    ends: reactive[tuple[str, str]] = reactive(("│", "│"))
    """What it has at its top and at its bottom."""

    class Dragged(Message):
        """The edge was dragged to a column of the screen."""

        def __init__(self, edge: Edge, column: int) -> None:
            super().__init__()
            self.edge = edge
            self.column = column

    def render_line(self, y: int) -> Strip:
        """Draw a piece of the line."""
        top, bottom = self.ends
        piece = top if y == 0 else bottom if y == self.size.height - 1 else "│"
        return Strip([Segment(piece, self.rich_style)])

    def on_mouse_down(self, event: events.MouseDown) -> None:
        """Begin to drag."""
        self.capture_mouse()
        event.stop()

    def on_mouse_move(self, event: events.MouseMove) -> None:
        """Drag."""
        if self.app.mouse_captured is self:
            self.post_message(self.Dragged(self, int(event.screen_x)))

    def on_mouse_up(self) -> None:
        """Let go."""
        self.release_mouse()


class Covered(Vertical):
    """A container that what is in it covers: to draw its lines one by one would be for nothing."""

    BLANK = True


class Dock(Covered):
    """Panels of which one is in sight."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("left_square_bracket", "turn(-1)", "Tab before", show=False, id="panel.previous"),
        Binding("right_square_bracket", "turn(1)", "Next tab", show=False, id="panel.next"),
        Binding("escape", "leave", "Editor", id="panel.leave", tooltip="Back to the editor"),
    ]

    class Turned(Message):
        """Another panel shall be in sight."""

        def __init__(self, dock: Dock, name: str) -> None:
            super().__init__()
            self.dock = dock
            self.name = name

    class Left(Message):
        """The editor shall have the focus again."""

    def __init__(self, side: str, panels: Iterable[Panel], widgets: PanelWidgets) -> None:
        """Make a dock.

        Args:
            side: the dock that it is, as panels name it; its id too.
            panels: all panels, of which it has those that are in it.
            widgets: the widgets of panels.
        """
        super().__init__(id=side)
        self.side = side
        self.panels = tuple(panel for panel in panels if panel.dock == side)
        self._widgets = widgets
        self.strip = TabStrip()
        self._body = Container(classes="dock-body")
        self.active = self.panels[0].name
        self.is_filled = False

    def compose(self) -> ComposeResult:
        """Make the strip, and the panel in sight; all others are made when they are shown."""
        if self.is_filled:
            yield self.strip
            with self._body:
                yield self.panel

    def fill(self) -> None:
        """Make what a dock needs that comes in sight."""
        if not self.is_filled:
            self.is_filled = True
            if self.is_mounted:
                self.mount(self.strip, self._body)
                self._body.mount(self.panel)

    def frame(self, *, left: bool, right: bool) -> None:
        """Draw the sides of a frame around the panel, with its tabs as the title; False for none.

        Where only one side is asked for, an `Edge` is the other one.
        """
        # What is not mounted yet is styled when it is.
        update = self._body.is_attached
        self._body.set_class(left, "-left", update=update)
        self._body.set_class(right, "-right", update=update)
        self.strip.corners = ("╭─" if left else "─" if right else "", "╮" if right else "")

    def holds(self, name: str) -> bool:
        """Tell whether a panel is in it."""
        return any(panel.name == name for panel in self.panels)

    def show(self, name: str) -> None:
        """Bring a panel in sight."""
        self.active = name
        for panel in self.panels:
            if panel.name in self._widgets.made:
                self._widgets[panel.name].display = panel.name == name
        if self.is_mounted and self.is_filled and not self.panel.is_attached:
            self._body.mount(self.panel)

    @property
    def panel(self) -> Widget:
        """The widget in sight."""
        return self._widgets[self.active]

    def on_descendant_focus(self) -> None:
        """Show in the strip that keys go to the panel below it."""
        self.set_class(True, "-focused")

    def on_descendant_blur(self) -> None:
        """Show that they do not."""
        self.set_class(self.has_focus_within, "-focused")

    def focus_panel(self) -> None:
        """Give the panel in sight the focus."""
        self.panel.focus()

    def action_turn(self, by: int) -> None:
        """Go to the next tab, or the one before."""
        names = [panel.name for panel in self.strip.tabs]
        at = names.index(self.active) if self.active in names else 0
        self.post_message(self.Turned(self, names[(at + by) % len(names)]))

    def action_leave(self) -> None:
        """Go back to the editor."""
        self.post_message(self.Left())
