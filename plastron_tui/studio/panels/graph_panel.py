"""The panel with the graph: boxes and arrows, with a cursor on one of the boxes."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from rich.segment import Segment
from rich.style import Style
from textual import events
from textual.binding import Binding, BindingType
from textual.geometry import Region
from textual.geometry import Size as Extent
from textual.scroll_view import ScrollView
from textual.strip import Strip

from .drawing import DETAILS
from .entry import Entry
from .entry_keys import Acting
from .fitting import Fitted, Size
from .panel import Resized
from .picture import Picture, picture_of
from .styles import COMPONENTS, Lines, Toned

if TYPE_CHECKING:
    from plastron_tui.output.graphs.wiring import Place

    from ..analysis import Analysis

_EMPTY = Fitted((), 0, {}, 0)
_SMALL = 16
"""So many boxes are drawn within a few milliseconds."""


class GraphPanel(Acting, Toned, ScrollView, can_focus=True):
    """A picture as large as fits, whose boxes can be chosen and acted on as entries can."""

    DEFAULT_CSS = """
    GraphPanel { background: $background; height: 1fr; overflow: auto auto; }
    GraphPanel > .graph-panel--cursor { background: $primary 60%; text-style: bold; }
    GraphPanel > .graph-panel--here { background: $primary 25%; }
    """
    COMPONENT_CLASSES: ClassVar[set[str]] = {
        *COMPONENTS,
        "graph-panel--cursor",
        "graph-panel--here",
    }
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("up,k", "go(0, -1)", "Up", show=False, id="panel.up"),
        Binding("down,j", "go(0, 1)", "Down", show=False, id="panel.down"),
        Binding("left,h", "go(-1, 0)", "Left", show=False, id="graph.left"),
        Binding("right,l", "go(1, 0)", "Right", show=False, id="graph.right"),
        Binding("home", "pick(0)", "First", show=False, id="panel.first"),
        Binding("end", "pick(-1)", "Last", show=False, id="panel.last"),
        Binding("shift+up,K", "scroll_up", "Scroll up", show=False, id="graph.scroll_up"),
        Binding("shift+down,J", "scroll_down", "Scroll down", show=False, id="graph.scroll_down"),
        Binding("shift+left,H", "scroll_left", "Scroll left", show=False, id="graph.scroll_left"),
        Binding("shift+right,L", "scroll_right", "Scroll right", show=False,
                id="graph.scroll_right"),
        Binding("pageup", "page_up", "Page up", show=False, id="panel.page_up"),
        Binding("pagedown", "page_down", "Page down", show=False, id="panel.page_down"),
        Binding("enter", "choose", "Go there", id="panel.choose", tooltip="Go to the statement"),
        Binding("s", "size", "Size", id="graph.size",
                tooltip="Draw it smaller; after the smallest size, again so that it fits"),
    ]  # fmt: skip

    def __init__(self, *, id: str | None = None) -> None:  # noqa: A002 - Textual's word
        super().__init__(id=id)
        self.picture = Picture()
        self._fitted = _EMPTY
        self._detail: int | None = None
        self._cursor: int | None = None
        self._here: int | None = None

    @property
    def room(self) -> Size:
        """The size in which the picture is wanted."""
        # The scroll bars come and go with what fits, and so must not decide what fits.
        width, height = self.outer_size
        return Size(width - 1, height, self._detail)

    @property
    def is_fitted(self) -> bool:
        """Whether what is shown is drawn for the room that there is."""
        return self.picture.is_fitted(self.room)

    @property
    def lines(self) -> Lines:
        """What is shown."""
        return self._fitted.lines

    @property
    def text(self) -> str:
        """The lines without their colours."""
        return "\n".join("".join(piece.text for piece in line) for line in self.lines)

    @property
    def current(self) -> Entry | None:
        """What the box is about that the cursor is on."""
        return None if self._cursor is None else self.picture.entries[self._cursor]

    @property
    def hint(self) -> str:
        """What the status line says while keys come here: how to see what is not in sight."""
        _, height = self.virtual_size
        if self.max_scroll_x or height > self.size.height:
            return "arrows: next box   Shift+arrows: scroll   s: size"
        return ""

    def request(self, analysis: Analysis | None, offset: int) -> Size:
        """Ask for the picture in the size that it is shown in."""
        return self.room

    def show(self, picture: Picture | None) -> None:
        """Show another picture, None for no; the cursor stays on its box."""
        picture = picture or Picture()
        if picture is not self.picture:
            self._cursor = self._cursor_in(picture)
            self._here = None
            self.picture = picture
            self._fitted = _EMPTY
        # A small one is drawn at once; a large one is drawn by the worker before it comes here.
        if self.is_fitted or 0 < len(picture.entries) <= _SMALL:
            self._fitted = picture.fitted(self.room)
        self.virtual_size = Extent(self._fitted.width + 1, len(self._fitted.lines))
        self._begin()
        if self.has_focus:
            # What was drawn anew has its boxes in other places.
            self._reveal()
        self.refresh()

    def _cursor_in(self, picture: Picture) -> int | None:
        """Return the box of another picture that the cursor goes to: of a new name, the same."""
        if self._cursor is None or not picture.entries:
            return None
        key = self.picture.entries[self._cursor].key
        numbers = {entry.key: number for number, entry in enumerate(picture.entries)}
        return numbers.get(key, min(self._cursor, len(picture.entries) - 1))

    def follow(self, offset: int) -> None:
        """Light the box of the statement at an offset."""
        here = self.picture.at(offset)
        if here == self._here:
            return
        self._here = here
        if here is not None and not self.has_focus:
            self._cursor = here
            self._reveal()
        self.refresh()

    def on_resize(self) -> None:
        """Ask for a picture that fits."""
        self.post_message(Resized())

    def on_show(self) -> None:
        """Ask for a picture that fits."""
        self.post_message(Resized())

    def action_size(self) -> None:
        """Draw it in the next smaller size; after the smallest so that it fits."""
        if self._detail is None:
            self._detail = 0
        elif self._detail + 1 < len(DETAILS):
            self._detail += 1
        else:
            self._detail = None
        how = "as large as fits" if self._detail is None else DETAILS[self._detail].title
        self.notify(f"size: {how}", timeout=2)
        self.post_message(Resized())

    def _place(self, box: int | None) -> Place | None:
        return None if box is None else self._fitted.places.get(box)

    def _reveal(self) -> None:
        place = self._place(self._cursor)
        if place is not None:
            self.scroll_to_region(Region(*place), animate=False, force=True)

    def _pick(self, box: int) -> None:
        if box != self._cursor:
            self._cursor = box
            self.refresh()
            self.refresh_bindings()
        self._reveal()

    def action_pick(self, number: int) -> None:
        """Go to the first box, or to the last one."""
        boxes = sorted(self._fitted.places, key=lambda box: self._fitted.places[box][:2])
        if boxes:
            self._pick(boxes[number])
            self.tell_current()

    def action_go(self, right: int, down: int) -> None:
        """Go to the nearest box in a direction."""
        here = self._place(self._cursor)
        if here is None:
            self.action_pick(0)
            return
        found = [
            (distance, box)
            for box, place in self._fitted.places.items()
            if (distance := _distance(here, place, right, down)) is not None
        ]
        if found:
            self._pick(min(found)[1])
            self.tell_current()
        elif right:
            self.scroll_relative(x=4 * right, animate=False)
        else:
            self.scroll_relative(y=down, animate=False)

    def on_click(self, event: events.Click) -> None:
        """Choose the box under the mouse."""
        x, y = event.x + self.scroll_offset.x, event.y + self.scroll_offset.y
        for box, place in self._fitted.places.items():
            if Region(*place).contains(x, y):
                self._pick(box)
                self.action_choose()
                return

    def on_focus(self) -> None:
        """Show the cursor."""
        self._begin()

    def _begin(self) -> None:
        """Put the cursor on a box, when there is one and the panel has the focus."""
        if self.has_focus and self._cursor is None and self._fitted.places:
            here = self._here
            self._cursor = here if here is not None else min(self._fitted.places)
            self.refresh_bindings()

    def render_line(self, y: int) -> Strip:
        """Draw a line."""
        width = self.scrollable_content_region.width
        base = self.rich_style
        x, top = self.scroll_offset
        row = top + y
        if row >= len(self.lines):
            return Strip.blank(width, base)
        strip = Strip([Segment(text, base + self.tone(tone)) for text, tone in self.lines[row]])
        for box, name in ((self._here, "here"), (self._cursor, "cursor")):
            place = self._place(box)
            if place is None or not place.y <= row < place.y + place.height:
                continue
            if name == "here" or self.has_focus:
                strip = _painted(strip, place, self.tone(name, "graph-panel"))
        return strip.crop(x, x + width).extend_cell_length(width, base)


def _painted(strip: Strip, place: Place, style: Style) -> Strip:
    """Return a line with the cells of a box in another style."""
    left, right = place.x, place.x + place.width
    inside = Strip([
        Segment(segment.text, (segment.style or Style.null()) + style)
        for segment in strip.crop(left, right)
    ])  # fmt: skip
    return Strip.join([strip.crop(0, left), inside, strip.crop(right, strip.cell_length)])


def _distance(here: Place, there: Place, right: int, down: int) -> float | None:
    """Return how far a box is in a direction, None when it is not there."""
    across = (there.x + there.width / 2) - (here.x + here.width / 2)
    # A row is about as high as two columns are wide.
    along = 2 * ((there.y + there.height / 2) - (here.y + here.height / 2))
    if right:
        return abs(across) + 2 * abs(along) if across * right > here.width / 2 else None
    return abs(along) + abs(across) if along * down > 0 else None


def make(analysis: Analysis, size: Size) -> Picture:
    """Lay the graph out, once, and draw it so that it fits, once for each size."""
    picture = analysis.once("picture", lambda: _laid_out(analysis))
    picture.fitted(size)
    return picture


def _laid_out(analysis: Analysis) -> Picture:
    workspace = analysis.workspace
    if workspace.robots and not workspace.nodes:
        return Picture(note="no nodes to draw; the panel of robots draws those")
    return picture_of(analysis.graph)
