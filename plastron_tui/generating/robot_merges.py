"""Bringing a robot's description by hand together with what a program makes of it."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from plastron_tui.ros.robots.merging import merged
from plastron_tui.sources.urdf.reader import read_urdf


class MergedRobot(NamedTuple):
    """What becomes of a robot's file; None with the reason."""

    text: bytes | None
    reason: str = ""


def merged_robot(
    path: Path, before: bytes, new: bytes, present: bytes, by_lines: bytes | None
) -> MergedRobot:
    """Bring what a program changes in a robot into its file, which was changed by hand.

    Lines that were merged count if they say what both together say; else it is changed there
    value by value.

    Args:
        path: the file.
        before: what the program made it as.
        new: what it makes it as now.
        present: what it holds.
        by_lines: what became of its lines, None where both changed the same.
    """
    from plastron_tui.sources.urdf.edits import edited

    robots = [read_urdf(text, path).description for text in (before, new, present)]
    known = [robot for robot in robots if robot is not None]
    if len(known) < len(robots):
        return MergedRobot(by_lines, "the program changed the same lines")
    wanted = merged(*known)
    if wanted.robot is None:
        return MergedRobot(None, f"the program changed the same: {wanted.clash}")
    if by_lines is not None and read_urdf(by_lines, path).description == wanted.robot:
        return MergedRobot(by_lines)
    changed = edited(present, known[-1], wanted.robot, path)
    reason = "; ".join(each.message for each in changed.diagnostics)
    return MergedRobot(changed.text, reason)
