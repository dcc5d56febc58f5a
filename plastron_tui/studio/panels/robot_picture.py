"""A robot as a picture of characters, in the size that fits where it is shown."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plastron_tui.model.robots import Robot
from plastron_tui.output.graphs.robots.captions import bodies_of
from plastron_tui.output.graphs.robots.runs import Run, RunLines
from plastron_tui.output.graphs.robots.text import Sides, draw_sides, look_at

from .styles import Lines, Piece

if TYPE_CHECKING:
    from plastron_tui.session import Session

_NOTHING = "what has a shape is seen here"

_TONES = {
    "title": "strong",
    "link": "primary",
    "quiet": "quiet",
    "axis": "secondary",
    "marked": "warning",
}
"""The tones of what is written into a picture."""


def sides_of(session: Session, robot: Robot) -> Sides:
    """Return a robot from all sides; the program measures its meshes, at first for seconds."""
    session.robots.measure(robot)
    return look_at(robot.shown, robot.meshes.get)


def picture_of(
    robot: Robot, sides: Sides, columns: int, rows: int, *, view: str = "", marked: str = ""
) -> Lines:
    """Return a robot as it looks, in so many columns and rows.

    Args:
        robot: the robot.
        sides: what it looks like.
        columns: how wide the picture is.
        rows: how high it is.
        view: the side that it is seen from: `top`, `side` or `front`; "" for all of them, or the
            one that shows most where there is no room for all.
        marked: the link or joint that stands out, "" for none.
    """
    if not any(map(bodies_of, robot.shown.links.values())):
        return ((Piece(f" {_NOTHING}", "quiet"),),)
    return _lines(draw_sides(sides, columns, rows, view=view, marked=marked))


def _lines(drawn: RunLines) -> Lines:
    return tuple(tuple(Piece(run.text, _tone(run)) for run in line) for line in drawn)


def _tone(run: Run) -> str:
    """Return the tone of a run: the colours that it has, or what its role has."""
    if not (run.color or run.behind):
        return _TONES.get(run.role, "")
    return f"{run.color} on {run.behind}" if run.behind else run.color
