"""Where the docks are: it depends on the window, and on what was chosen."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping

from textual import events, on
from textual.app import ComposeResult
from textual.containers import Horizontal
from textual.geometry import Size
from textual.widget import Widget

from ..config import Remembered
from ..panels.dock import Covered, Dock, Edge, TabStrip
from ..panels.panel import Panel, PanelWidgets

WIDE = 150
"""From so many columns on, there is a dock on either side of the editor and one below."""
MEDIUM = 104
"""From so many columns on, there is a dock at its left and one below; with fewer, only below."""
TEXT = 80
"""The columns that the text gets before the dock at its right gets more."""
FRAMED = 30
"""From so many rows on, in a window that is not narrow, all that takes keys has a frame."""
LOW = 14
"""With fewer rows the text has the window, as long as no panel has the focus."""

_OUTLINE_COLUMNS = 34
_MOST_OUTLINE = 48
SIDE_COLUMNS = 40
"""The columns of what is put at the side of all docks."""
_LEAST = 3
_EDITOR_COLUMNS, _EDITOR_ROWS = 30, 4


class DockLayout(Horizontal):
    """The editor and the docks around it, which it shows, hides, resizes and enlarges.

    Attributes:
        sizes: how large each dock is that was resized, in cells.
        front: the dock that is in sight where not all are.
    """

    BLANK = True

    def __init__(
        self,
        panels: Iterable[Panel],
        widgets: PanelWidgets,
        editor: Widget,
        remembered: Remembered,
        on_change: Callable[[], object],
    ) -> None:
        """Make the docks.

        Args:
            panels: all panels.
            widgets: their widgets.
            editor: what is in the middle.
            remembered: how it was laid out last time.
            on_change: called when other panels may be in sight.
        """
        super().__init__(id="body")
        self._editor = editor
        self._remembered = remembered
        self._on_change = on_change
        self.outline, self.result, self.bottom = self.docks = tuple(
            Dock(side, panels, widgets) for side in ("outline", "result", "bottom")
        )
        self._outline_edge, self._result_edge = Edge(id="outline-edge"), Edge(id="result-edge")
        self._center = Covered(id="center")
        self.sizes = {dock.side: 0 for dock in self.docks}
        self.front = self.outline
        self._counts: Mapping[str, int] = {}
        self._entering: Dock | None = None
        """The dock that is about to get the focus."""
        self._hides_panels = False
        self._is_zoomed = False
        self._fitted = Size()
        self._left: Widget | None = None
        """What had the focus before that."""
        self.side: Widget | None = None
        """What is at the right of all docks, if anything is."""

    def compose(self) -> ComposeResult:
        """Make the docks, and of their panels those that are in sight at first."""
        self._restore()
        # What is mounted with its classes is styled once.
        self._arrange()
        yield self.outline
        yield self._outline_edge
        with self._center:
            yield self._editor
            yield self.bottom
        yield self._result_edge
        yield self.result

    def _restore(self) -> None:
        """Lay out as it was last time."""
        remembered = self._remembered
        for side, size in remembered.sizes.items():
            if side in self.sizes and size >= _LEAST:
                self.sizes[side] = size
        self._hides_panels = "all" in remembered.hidden
        for dock in self.docks:
            tab = remembered.tabs.get(dock.side, "")
            if any(panel.name == tab and panel.is_kept for panel in dock.panels):
                dock.show(tab)
            if remembered.tabs.get("front") == dock.side:
                self.front = dock

    def remember(self) -> None:
        """Remember how it is laid out."""
        remembered = self._remembered
        remembered.sizes = {side: size for side, size in self.sizes.items() if size}
        remembered.hidden = ["all"] if self._hides_panels else []
        remembered.tabs = {dock.side: dock.active for dock in self.docks}
        remembered.tabs["front"] = self.front.side

    @property
    def shape(self) -> str:
        """How the window is divided: `wide`, `medium` or `narrow`."""
        width = self._window.width
        return "wide" if width >= WIDE else "medium" if width >= MEDIUM else "narrow"

    @property
    def is_framed(self) -> bool:
        """Whether there is room for frames; else there is only the line with the tabs."""
        return self.shape != "narrow" and self.app.size.height >= FRAMED

    def _places(self) -> dict[Dock, str]:
        """Return where each dock that is in sight is: `left`, `right` or `below`."""
        is_low = self.shape == "narrow" and self.app.size.height < LOW
        if (self._hides_panels or is_low) and self.focused_dock is None:
            return {}
        if self.shape == "wide":
            return {self.outline: "left", self.result: "right", self.bottom: "below"}
        if self.shape == "medium":
            lower = self.bottom if self.front is self.outline else self.front
            return {self.outline: "left", lower: "below"}
        return {self.front: "below"}

    @property
    def focused_dock(self) -> Dock | None:
        """The dock that has the focus, or is about to get it."""
        focused = self.screen.focused
        if self._entering is not None or focused is None:
            return self._entering
        return next((each for each in focused.ancestors_with_self if isinstance(each, Dock)), None)

    def fit(self) -> None:
        """Lay the docks out for another size of the window."""
        if self.app.size != self._fitted:
            self._fitted = self.app.size
            self.lay_out()

    @property
    def _window(self) -> Size:
        """The window, without what is at its side."""
        width, height = self.app.size
        return Size(width if self.side is None else max(1, width - SIDE_COLUMNS), height)

    def put_at_side(self, side: Widget | None) -> None:
        """Put something at the right, beside all docks; it has the focus until it goes."""
        if self.side is not None:
            if self.side.has_focus and self._left is not None:
                self._left.focus()
            self.side.remove()
        self.side, self._left = side, self.screen.focused
        if side is not None:
            side.styles.width = SIDE_COLUMNS
            self.mount(side)
            side.focus()
        self.lay_out()

    def lay_out(self) -> None:
        """Lay the docks out."""
        self._arrange()
        self._on_change()

    def _arrange(self) -> None:
        places = self._places()
        zoomed = self.focused_dock if self._is_zoomed else None
        if zoomed is not None:
            places = {zoomed: "all"}
        for dock in self.docks:
            dock.display = dock in places
            if dock in places:
                dock.fill()
                self._place(dock, places[dock])
        is_framed = self.is_framed
        self._outline_edge.display = places.get(self.outline) == "left"
        self._outline_edge.ends = ("╮", "╯") if is_framed else ("│", "│")
        self._result_edge.display = places.get(self.result) == "right"
        self._result_edge.ends = ("╭", "╰") if is_framed else ("│", "│")
        self._editor.set_class(is_framed, "-framed", update=self._editor.is_attached)
        self._editor.display = zoomed is None
        self._center.display = zoomed in (None, self.bottom)
        self._show_tabs()

    def _place(self, dock: Dock, place: str) -> None:
        width, height = self._window
        dock.styles.dock = "none"
        # What is not mounted yet is styled when it is.
        dock.set_class(place in ("below", "all"), "-below", update=dock.is_attached)
        dock.frame(left=self.is_framed and place != "right",
                   right=self.is_framed and place != "left")  # fmt: skip
        if place == "all":
            dock.styles.width, dock.styles.height = "1fr", "1fr"
        elif place == "below":
            rows = self.sizes["bottom"] or self._usual_rows(dock)
            most = max(_LEAST, height - 3 - _EDITOR_ROWS)
            dock.styles.width = "100%"
            dock.styles.height = min(rows, most)
            dock.styles.dock = "none" if dock is self.bottom else "bottom"
        else:
            # Long names and types are seen whole where the window has columns to spare.
            outline = min(_MOST_OUTLINE, _OUTLINE_COLUMNS + max(0, width - WIDE) // 5)
            usual = outline if dock is self.outline else max(40, width - outline - 4 - TEXT)
            columns = self.sizes[dock.side] or usual
            dock.styles.width = max(_LEAST, min(columns, width - _EDITOR_COLUMNS))
            dock.styles.height = "100%"

    def _usual_rows(self, dock: Dock) -> int:
        height = self.app.size.height
        if self.shape == "wide" and dock is self.bottom:
            return max(5 + self.is_framed, height // 6)
        return max(6, height * 2 // 5)

    def show_counts(self, counts: Mapping[str, int]) -> None:
        """Show beside the names of the panels how much is in them."""
        self._counts = counts
        self._show_tabs()

    def _show_tabs(self) -> None:
        """Show in each strip the tabs that can be reached from it."""
        groups = {
            "wide": ((self.outline,), (self.result,), (self.bottom,)),
            "medium": ((self.outline,), (self.result, self.bottom)),
            "narrow": (self.docks,),
        }[self.shape]
        for group in groups:
            tabs = [panel for dock in group for panel in dock.panels]
            for dock in group:
                dock.strip.show(tabs, dock.active, self._counts)

    def dock_of(self, name: str) -> Dock:
        """Return the dock that holds a panel."""
        return next(dock for dock in self.docks if dock.holds(name))

    def is_in_sight(self, name: str) -> bool:
        """Tell whether a panel is shown."""
        dock = self.dock_of(name)
        return bool(dock.display) and dock.active == name

    def reveal(self, name: str) -> None:
        """Bring a panel in sight; the editor keeps the focus if it has it and there is room."""
        self._hides_panels = False
        self.bring(name, focus=self.focused_dock is not None)
        if not self.is_in_sight(name):
            self.bring(name, focus=True)

    def bring(self, name: str, *, focus: bool = False) -> None:
        """Bring a panel in sight."""
        dock = self.dock_of(name)
        dock.show(name)
        if not (self.shape == "medium" and dock is self.outline):
            self.front = dock
        if focus:
            self._hides_panels = False
            self._entering = dock
        self.lay_out()
        if focus:
            dock.focus_panel()
            self.call_after_refresh(self._entered)

    def _entered(self) -> None:
        """Give the panel the focus again, if it went away with the panel that had it."""
        dock, self._entering = self._entering, None
        if dock is not None and self.focused_dock is not dock:
            dock.focus_panel()

    @on(events.DescendantFocus)
    @on(events.DescendantBlur)
    def _light_edges(self) -> None:
        """Let the edges have the colour of the frames that they are sides of."""
        self._outline_edge.set_class(self.outline.has_focus_within, "-focused")
        self._result_edge.set_class(self.result.has_focus_within, "-focused")

    @on(TabStrip.Picked)
    @on(Dock.Turned)
    def _picked(self, message: TabStrip.Picked | Dock.Turned) -> None:
        """Show the panel of a tab."""
        self.bring(message.name, focus=True)

    @on(Dock.Left)
    def leave(self) -> None:
        """Go back to the editor."""
        self._is_zoomed = False
        self._entering = None
        self._editor.display = True
        self._editor.focus()
        self.call_after_refresh(self.lay_out)

    def next_panel(self) -> None:
        """Give the next panel the focus; after the last one the editor."""
        here = self.focused_dock
        self._is_zoomed = False
        if self.shape == "wide":
            names = [dock.active for dock in self.docks]
        else:
            names = [panel.name for dock in self.docks for panel in dock.panels]
            if here is None:
                self.bring(self.front.active, focus=True)
                return
        at = -1 if here is None else names.index(here.active)
        if at + 1 < len(names):
            self.bring(names[at + 1], focus=True)
        else:
            self.leave()

    def toggle(self) -> None:
        """Hide all panels, or show them again."""
        self._hides_panels = not self._hides_panels
        if self._hides_panels:
            self._editor.focus()
        self.call_after_refresh(self.lay_out)

    def zoom(self) -> None:
        """Let the panel with the focus have the window, or its place again."""
        if self.focused_dock is None:
            self.bring(self.front.active, focus=True)
        self._is_zoomed = not self._is_zoomed
        self.call_after_refresh(self.lay_out)

    def enlarge(self, by: int) -> None:
        """Give the panel with the focus, or the one in front, more room, or less."""
        dock = self.focused_dock or self.front
        match self._places().get(dock):
            case "below":
                now = self.sizes["bottom"] or dock.size.height + 1
                self.sizes["bottom"] = max(_LEAST, now + by // 2)
            case "left" | "right":
                self.sizes[dock.side] = max(_LEAST * 4, dock.outer_size.width + by)
        self.lay_out()

    @on(Edge.Dragged)
    def _edge_dragged(self, message: Edge.Dragged) -> None:
        """Follow the mouse with the edge of a dock."""
        if message.edge.id == "outline-edge":
            self.sizes["outline"] = max(_LEAST * 4, message.column)
        else:
            self.sizes["result"] = max(_LEAST * 4, self._window.width - message.column - 1)
        self.lay_out()

    @on(TabStrip.Dragged)
    def _strip_dragged(self, message: TabStrip.Dragged) -> None:
        """Follow the mouse with the upper edge of the dock below."""
        parent = message.strip.parent
        if isinstance(parent, Dock) and self._places().get(parent) == "below":
            self.sizes["bottom"] = max(_LEAST, self.app.size.height - 2 - message.row)
            self.lay_out()
