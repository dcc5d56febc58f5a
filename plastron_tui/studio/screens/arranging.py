"""Where the panels of the main screen are: it depends on the window, and on what was chosen."""

from __future__ import annotations

from typing import TYPE_CHECKING, cast

from textual import on

from ..panels.dock import Dock, Edge, TabStrip
from ..panels.key_bar import KeyBar
from .part import Part

if TYPE_CHECKING:
    from ..app import StudioApp

WIDE = 150
"""From so many columns on, there is a dock on either side of the editor and one below."""
MEDIUM = 104
"""From so many columns on, there is a dock at its left and one below; with fewer, only below."""
TEXT = 80
"""The columns that the text gets before the dock at its right gets more."""
LOW = 14
"""With fewer rows the text has the window, as long as no panel has the focus."""

SIZES = {"outline": 34, "result": 0, "bottom": 0}
_LEAST = 3
_EDITOR_COLUMNS, _EDITOR_ROWS = 30, 4


class Arranging(Part):
    """Shows, hides, resizes and enlarges docks."""

    outline: Dock
    result: Dock
    bottom: Dock
    front = "outline"
    """The dock that is in sight where not all are."""
    entering: Dock | None = None
    """The dock that is about to get the focus."""
    hides_panels = False
    is_zoomed = False
    counts: dict[str, str]

    def __init__(self) -> None:
        super().__init__()
        self.sizes = dict(SIZES)
        self.counts = {}

    @property
    def docks(self) -> tuple[Dock, Dock, Dock]:
        """All docks."""
        return self.outline, self.result, self.bottom

    def restore_layout(self) -> None:
        """Lay out as it was last time."""
        remembered = cast("StudioApp", self.app).remembered
        for name, size in remembered.sizes.items():
            if name in self.sizes and size >= _LEAST:
                self.sizes[name] = size
        self.hides_panels = "all" in remembered.hidden
        for dock in self.docks:
            tab = remembered.tabs.get(dock.id or "", "")
            if tab in dict(dock.titles):
                dock.show(tab)
        if remembered.tabs.get("front") in {dock.id for dock in self.docks}:
            self.front = remembered.tabs["front"]

    def fill_docks(self) -> None:
        """Prepare the docks that are in sight at first."""
        self.restore_layout()
        for name in self._beside():
            self.dock_of_id(name).fill()

    def remember_layout(self) -> None:
        """Remember how it is laid out."""
        remembered = cast("StudioApp", self.app).remembered
        remembered.sizes = {name: size for name, size in self.sizes.items() if size}
        remembered.hidden = ["all"] if self.hides_panels else []
        remembered.tabs = {dock.id or "": dock.active for dock in self.docks}
        remembered.tabs["front"] = self.front

    @property
    def shape(self) -> str:
        """How the window is divided: `wide`, `medium` or `narrow`."""
        width = self.app.size.width
        return "wide" if width >= WIDE else "medium" if width >= MEDIUM else "narrow"

    def _beside(self) -> dict[str, str]:
        """Return where each dock that is in sight is: `left`, `right` or `below`."""
        if self.hides_panels and not self._focused_dock():
            return {}
        shape = self.shape
        if shape == "wide":
            return {"outline": "left", "result": "right", "bottom": "below"}
        lower = self.front
        if shape == "medium":
            lower = "bottom" if lower == "outline" else lower
            return {"outline": "left", lower: "below"}
        if self.app.size.height < LOW and not self._focused_dock():
            return {}
        return {lower: "below"}

    def _focused_dock(self) -> Dock | None:
        if self.entering is not None:
            return self.entering
        focused = self.focused
        if focused is None:
            return None
        return next((dock for dock in self.docks if dock in focused.ancestors_with_self), None)

    def lay_docks(self) -> None:
        """Lay the docks out."""
        places = self._beside()
        zoomed = self._focused_dock() if self.is_zoomed else None
        if zoomed is not None:
            places = {zoomed.id or "": "all"}
        for dock in self.docks:
            place = places.get(dock.id or "")
            dock.display = place is not None
            if place is not None:
                dock.fill()
                self._place(dock, place)
        self.query_one("#outline-edge", Edge).display = places.get("outline") == "left"
        self.query_one("#result-edge", Edge).display = places.get("result") == "right"
        self.editor.display = zoomed is None
        center = self.query_one("#center")
        center.display = zoomed is None or zoomed is self.bottom
        self.query_one(KeyBar).display = self.app.size.height >= 8
        self.show_tabs()
        self.follow()

    def _place(self, dock: Dock, place: str) -> None:
        width, height = self.app.size
        name = dock.id or ""
        dock.styles.dock = "none"
        dock.set_class(place in ("below", "all"), "-below")
        if place == "all":
            dock.styles.width, dock.styles.height = "1fr", "1fr"
        elif place == "below":
            rows = self.sizes["bottom"] or self._usual_rows(name)
            most = max(_LEAST, height - 3 - _EDITOR_ROWS)
            dock.styles.width = "100%"
            dock.styles.height = min(rows, most)
            dock.styles.dock = "none" if dock is self.bottom else "bottom"
        else:
            usual = {"outline": SIZES["outline"], "result": max(40, width - 36 - TEXT)}[name]
            columns = self.sizes[name] or usual
            dock.styles.width = max(_LEAST, min(columns, width - _EDITOR_COLUMNS))
            dock.styles.height = "100%"

    def _usual_rows(self, name: str) -> int:
        height = self.app.size.height
        if self.shape == "wide" and name == "bottom":
            return max(5, height // 6)
        return max(6, height * 2 // 5)

    # Tabs.

    def show_tabs(self) -> None:
        """Show in each strip the tabs that can be reached from it."""
        shape = self.shape
        groups = {
            "wide": ((self.outline,), (self.result,), (self.bottom,)),
            "medium": ((self.outline,), (self.result, self.bottom)),
            "narrow": (self.docks,),
        }[shape]
        for group in groups:
            tabs = [tab for dock in group for tab in dock.titles]
            for dock in group:
                dock.strip.show(tabs, dock.active, self.counts)

    def dock_of(self, name: str) -> Dock:
        """Return the dock that holds a panel."""
        return next(dock for dock in self.docks if name in dict(dock.titles))

    def is_in_sight(self, name: str) -> bool:
        """Tell whether a panel is shown."""
        dock = self.dock_of(name)
        return bool(dock.display) and dock.active == name

    def bring(self, name: str, *, focus: bool = False) -> None:
        """Bring a panel in sight."""
        dock = self.dock_of(name)
        dock.show(name)
        if not (self.shape == "medium" and dock is self.outline):
            self.front = dock.id or ""
        if focus:
            self.hides_panels = False
            self.entering = dock
        self.lay_docks()
        if focus:
            dock.focus_panel()
            self.call_after_refresh(self._entered)
        self.ask_more()

    def _entered(self) -> None:
        """Give the panel the focus again, if it went away with the panel that had it."""
        dock, self.entering = self.entering, None
        if dock is not None and self._focused_dock() is not dock:
            dock.focus_panel()

    @on(TabStrip.Picked)
    def tab_picked(self, message: TabStrip.Picked) -> None:
        """Show the panel whose tab was clicked."""
        self.bring(message.name, focus=True)

    @on(Dock.Turned)
    def dock_turned(self, message: Dock.Turned) -> None:
        """Show the next panel of a dock."""
        self.bring(message.name, focus=True)

    @on(Dock.Left)
    def dock_left(self) -> None:
        """Go back to the editor."""
        self.is_zoomed = False
        self.entering = None
        self.editor.display = True
        self.editor.focus()
        self.call_after_refresh(self.lay_docks)

    # Actions.

    def action_show(self, name: str) -> None:
        """Bring a panel in sight and give it the focus."""
        self.bring(name, focus=True)

    def action_next_panel(self) -> None:
        """Give the next panel the focus; after the last one the editor."""
        here = self._focused_dock()
        self.is_zoomed = False
        if self.shape == "wide":
            order = list(self.docks)
            at = -1 if here is None else order.index(here)
            if at + 1 == len(order):
                self.dock_left()
            else:
                self.bring(order[at + 1].active, focus=True)
            return
        names = [name for dock in self.docks for name, _ in dock.titles]
        at = names.index(here.active) if here is not None else -1
        if here is None:
            self.bring(self.dock_of_id(self.front).active, focus=True)
        elif at + 1 == len(names):
            self.dock_left()
        else:
            self.bring(names[at + 1], focus=True)

    def dock_of_id(self, name: str) -> Dock:
        """Return a dock by its id."""
        return next(dock for dock in self.docks if dock.id == name)

    def action_panels(self) -> None:
        """Hide all panels, or show them again."""
        self.hides_panels = not self.hides_panels
        if self.hides_panels:
            self.editor.focus()
        self.call_after_refresh(self.lay_docks)

    def action_zoom(self) -> None:
        """Let the panel with the focus have the window, or its place again."""
        if self._focused_dock() is None:
            self.bring(self.dock_of_id(self.front).active, focus=True)
        self.is_zoomed = not self.is_zoomed
        self.call_after_refresh(self.lay_docks)

    def action_resize(self, by: int) -> None:
        """Give the panel with the focus, or the one below, more room or less."""
        dock = self._focused_dock() or self.dock_of_id(self.front)
        place = self._beside().get(dock.id or "")
        if place == "below":
            now = self.sizes["bottom"] or dock.size.height + 1
            self.sizes["bottom"] = max(_LEAST, now + by // 2)
        elif place is not None:
            name = dock.id or ""
            self.sizes[name] = max(_LEAST * 4, dock.outer_size.width + by)
        self.lay_docks()

    @on(Edge.Dragged)
    def edge_dragged(self, message: Edge.Dragged) -> None:
        """Follow the mouse with the edge of a dock."""
        width = self.app.size.width
        if message.edge.id == "outline-edge":
            self.sizes["outline"] = max(_LEAST * 4, message.column)
        else:
            self.sizes["result"] = max(_LEAST * 4, width - message.column - 1)
        self.lay_docks()

    @on(TabStrip.Dragged)
    def strip_dragged(self, message: TabStrip.Dragged) -> None:
        """Follow the mouse with the upper edge of the dock below."""
        parent = message.strip.parent
        if isinstance(parent, Dock) and self._beside().get(parent.id or "") == "below":
            self.sizes["bottom"] = max(_LEAST, self.app.size.height - 2 - message.row)
            self.lay_docks()
