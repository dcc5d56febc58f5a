"""The panel with the robots: a tree of links and joints, and beside it how one looks."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar, NamedTuple

from textual import events, on
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Container

from .entry import Entries, Subject
from .entry_keys import Lit
from .panel import Resized
from .program_panel import ProgramPanel
from .styles import Lines
from .text_view import TextView

if TYPE_CHECKING:
    from typing_extensions import Self

    from ..analysis import Analysis

_TREE_COLUMNS = 30, 60
"""The least and the most columns of the tree beside a picture."""

_LOW = 6
"""With fewer rows there is no picture below the tree."""

_NARROW = 24
"""With fewer columns there is none beside it."""


_VIEWS = {"": "all views", "top": "from above", "side": "from its right", "front": "from its front"}
"""What can be shown: all of it as far as there is room, or one view."""


class Looks(NamedTuple):
    """A picture that is wanted.

    Attributes:
        robot: the variable of the robot.
        columns: how wide the picture is to be.
        rows: how high it is to be, 0 for no picture.
        view: the view that is wanted alone, "" for as many as there is room for.
        marked: the link or the joint that stands out, "" for none.
    """

    robot: str | None
    columns: int
    rows: int
    view: str = ""
    marked: str = ""


class Shown(NamedTuple):
    """What the panel shows: the entries of all robots, and the picture of one."""

    entries: Entries
    picture: Lines


class RobotPanel(Container):
    """A tree, and a picture that is as large as fits."""

    DEFAULT_CSS = """
    RobotPanel { height: 1fr; width: 100%; layout: vertical; }
    RobotPanel > #robot-picture { overflow: hidden hidden; }
    RobotPanel.-beside { layout: horizontal; }
    RobotPanel.-beside > #robot-tree { width: 1fr; height: 100%; }
    """
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("v", "view", "View", id="robots.view",
                tooltip="See it from above, from its right, from its front, or from all of them"),
    ]  # fmt: skip

    def __init__(self, *, id: str | None = None) -> None:  # noqa: A002 - Textual's word
        super().__init__(id=id)
        self._robot: str | None = None
        self._is_awaited = False
        self.parts = ProgramPanel(id="robot-tree")
        self.picture = TextView(id="robot-picture")
        self.picture.can_focus = False
        self._view = ""

    def compose(self) -> ComposeResult:
        """Make the tree and the picture."""
        yield self.parts
        yield self.picture

    def focus(self, scroll_visible: bool = True) -> Self:
        """Give the tree the focus."""
        self._is_awaited = not self.parts.is_attached
        if not self._is_awaited:
            self.parts.focus(scroll_visible)
        return self

    def on_mount(self) -> None:
        """Give the tree the focus that somebody wanted for it before it was there."""
        if self._is_awaited:
            self.focus()

    @property
    def _room(self) -> tuple[int, int]:
        """The columns and rows of the picture; it has the rest of what the tree needs."""
        width, height = self.size
        # A row is about as high as two columns are wide.
        if width > 3 * height:
            least, most = _TREE_COLUMNS
            columns = width - min(max(least, width * 2 // 5), most)
            return (columns, height) if columns >= _NARROW else (0, 0)
        rows = height - min(len(self.parts.entries.all) + 1, height * 2 // 5)
        return (width, rows) if rows >= _LOW else (0, 0)

    def on_resize(self, event: events.Resize) -> None:
        """Have the picture beside the tree, or below it, and drawn so that it fits."""
        self._lay_out()
        self.post_message(Resized())

    def _lay_out(self) -> None:
        columns, rows = self._room
        is_beside = rows == self.size.height
        self.set_class(is_beside, "-beside")
        self.picture.display = bool(rows)
        self.picture.styles.width = columns if is_beside else "100%"
        self.picture.styles.height = "100%" if is_beside else rows

    def request(self, analysis: Analysis | None, offset: int) -> Looks | None:
        """Ask for the robot at the cursor, or else for the last one, or the first."""
        if analysis is None:
            return None
        robots = analysis.workspace.robots
        last = self._robot if self._robot in robots else next(iter(robots), None)
        self._robot = analysis.robot_at(offset) or last
        columns, rows = self._room
        return Looks(self._robot, columns, rows, self._view, self._marked(offset) if rows else "")

    def _marked(self, offset: int) -> str:
        """Return the part that stands out: the one at the cursor, in the tree or in the text."""
        entry = self.parts.current if self.parts.has_focus else self.parts.entries.at(offset)
        is_part = entry is not None and entry.subject in (Subject.LINK, Subject.JOINT)
        return entry.text if entry is not None and is_part and entry.robot == self._robot else ""

    def show(self, content: Shown | None) -> None:
        """Show the robots; None for none."""
        entries, picture = content or Shown(Entries(), ())
        is_other = entries is not self.parts.entries
        self.parts.show(entries)
        self.picture.show(picture)
        if self.has_focus_within:
            self.refresh_bindings()
        if is_other and self.size:
            # The tree may need more rows now, or fewer, and another part be at the cursor.
            self._lay_out()
            self.post_message(Resized())

    @on(Lit)
    @on(events.DescendantFocus)
    @on(events.DescendantBlur)
    def mark(self) -> None:
        """Let the part stand out that the tree's cursor is on, or else the one in the text."""
        self.post_message(Resized())

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """Offer other views of what is shown."""
        return action != "view" or bool(self.picture.display and self.picture.lines)

    def action_view(self) -> None:
        """See it from another side."""
        names = list(_VIEWS)
        self._view = names[(names.index(self._view) + 1) % len(names)]
        self.notify(_VIEWS[self._view], timeout=2)
        self.post_message(Resized())

    def follow(self, offset: int) -> None:
        """Light the part that the statement at an offset is about."""
        self.parts.follow(offset)


def make(analysis: Analysis, looks: Looks) -> Shown:
    """Make what the panel shows."""
    from .robot_entries import robot_entries
    from .robot_picture import picture_of, sides_of

    entries = analysis.once("robots", lambda: robot_entries(analysis))
    robot = analysis.workspace.robots.get(looks.robot or "")
    if robot is None or not looks.rows:
        return Shown(entries, ())
    size = looks.columns, looks.rows
    # What stands out, and how large all is, changes more often than the robot.
    sides = analysis.once(("sides", robot.variable), lambda: sides_of(analysis.session, robot))
    picture = picture_of(robot, sides, *size, view=looks.view, marked=looks.marked)
    return Shown(entries, picture)


def count(analysis: Analysis) -> int:
    """Return how much there is."""
    return len(analysis.workspace.robots)
