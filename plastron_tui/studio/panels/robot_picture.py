"""A robot as a picture of characters, in the size that fits where it is shown."""

from __future__ import annotations

from plastron_tui.ros.robots.description import Description

from .styles import Lines


def picture_of(robot: Description, columns: int, rows: int) -> Lines:
    """Return a robot as it looks, in so many columns and rows."""
    return ()
