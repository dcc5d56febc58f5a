"""The panel with the robots: a tree of links and joints, and beside it how one looks."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from textual import events
from textual.app import ComposeResult
from textual.containers import Container

from .entry import Entries
from .panel import Panel, Resized
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


class Looks(NamedTuple):
    """A picture that is wanted: of which robot, and for how many columns and rows."""

    robot: str | None
    columns: int
    rows: int


class Shown(NamedTuple):
    """What the panel shows: the entries of all robots, and the picture of one."""

    entries: Entries
    picture: Lines


class RobotPanel(Container):
    """A tree, and a picture that is as large as fits."""

    def __init__(self, *, id: str | None = None) -> None:  # noqa: A002 - Textual's word
        super().__init__(id=id)
        self._robot: str | None = None
        self._is_awaited = False
        self.parts = ProgramPanel(id="robot-tree")
        self.picture = TextView(id="robot-picture")

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
        return Looks(self._robot, *self._room)

    def show(self, content: Shown | None) -> None:
        """Show the robots; None for none."""
        entries, picture = content or Shown(Entries(), ())
        had = len(self.parts.entries.all)
        self.parts.show(entries)
        self.picture.show(picture)
        if had != len(entries.all) and self.size:
            before = self._room
            self._lay_out()
            if before != self._room:
                self.post_message(Resized())

    def follow(self, offset: int) -> None:
        """Light the part that the statement at an offset is about."""
        self.parts.follow(offset)


def _made(analysis: Analysis, looks: Looks) -> Shown:
    from .robot_entries import robot_entries
    from .robot_picture import picture_of

    entries = analysis.once("robots", lambda: robot_entries(analysis))
    robot = analysis.workspace.robots.get(looks.robot or "")
    if robot is None or not looks.rows:
        return Shown(entries, ())
    return Shown(entries, picture_of(robot.description, looks.columns, looks.rows))


ROBOTS = Panel(
    name="robots",
    title="Robot",
    dock="result",
    keys="alt+l",
    summary="The robots: their links and joints as a tree, and how one looks.",
    about=(
        "Each robot ◈ with its links ■, in their colours, each below the joint that holds it: "
        "fixed ─, revolute ◠, continuous ○, prismatic ⇄, planar ▱, floating ∗. Enter goes to the "
        "statement; Delete writes the one that takes a part away; G the one that writes it all."
    ),
    widget=RobotPanel,
    make=_made,
    count=lambda analysis: len(analysis.workspace.robots),
    is_slow=True,
)
