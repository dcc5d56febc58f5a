"""Bringing a robot's file that was changed by hand together with what a program makes of it."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from plastron_tui.sources.urdf.edits import edited
from plastron_tui.sources.urdf.equality import same_robot
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
    first, last = read_urdf(before).description, read_urdf(new).description
    if first is None or last is None or read_urdf(present).description is None:
        return MergedRobot(by_lines, "the program changed the same lines")
    changed = edited(present, first, last, path)
    if changed.text is None:
        return MergedRobot(None, "; ".join(each.message for each in changed.diagnostics))
    of_lines = None if by_lines is None else read_urdf(by_lines).description
    wanted = read_urdf(changed.text).description
    if of_lines is not None and wanted is not None and same_robot(of_lines, wanted):
        return MergedRobot(by_lines)
    return MergedRobot(changed.text)
