"""A robot as a picture of characters, in the size that fits where it is shown."""

from __future__ import annotations

from plastron_tui.model.robots import Robot
from plastron_tui.output.graphs.robots.captions import bodies_of
from plastron_tui.output.graphs.robots.runs import Run, RunLines
from plastron_tui.output.graphs.robots.text import render_views
from plastron_tui.session import Session

from .styles import Lines, Piece

_NOTHING = "what has a shape is seen here"

_TONES = {
    "title": "strong",
    "link": "primary",
    "joint": "success",
    "quiet": "quiet",
    "axis": "secondary",
    "marked": "warning",
}
"""The tones of what is written into a picture."""


def picture_of(
    session: Session, robot: Robot, columns: int, rows: int, *, view: str = "", marked: str = ""
) -> Lines:
    """Return a robot as it looks, in so many columns and rows.

    Args:
        session: the program, which measures meshes; the first time that may take seconds.
        robot: the robot.
        columns: how wide the picture is.
        rows: how high it is.
        view: the side that it is seen from: `top`, `side` or `front`; "" for all of them, or the
            one that shows most where there is no room for all.
        marked: the link or joint that stands out, "" for none.
    """
    session.robots.measure(robot)
    if not any(map(bodies_of, robot.shown.links.values())):
        return ((Piece(f" {_NOTHING}", "quiet"),),)
    bounds = robot.meshes.get
    drawn = render_views(robot.shown, columns, rows, view=view, marked=marked, mesh_bounds=bounds)
    return _lines(drawn)


def _lines(drawn: RunLines) -> Lines:
    return tuple(tuple(Piece(run.text, _tone(run)) for run in line) for line in drawn)


def _tone(run: Run) -> str:
    """Return the tone of a run: the colours that it has, or what its role has."""
    if not (run.color or run.behind):
        return _TONES.get(run.role, "")
    return f"{run.color} on {run.behind}" if run.behind else run.color
