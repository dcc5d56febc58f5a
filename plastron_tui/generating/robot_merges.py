"""Bringing a robot's file that was changed by hand together with what a program makes of it."""

from __future__ import annotations

from pathlib import Path

from plastron_tui.output.merge3 import MergedText
from plastron_tui.sources.urdf.edits import edited
from plastron_tui.sources.urdf.reader import read_urdf


def merged_robot(path: Path, before: bytes, new: bytes, present: bytes) -> MergedText | None:
    """Bring what a program changes in a robot into its file, value by value.

    Args:
        path: the file.
        before: what the program made it as.
        new: what it makes it as now.
        present: what it holds.

    Returns:
        None where what the program makes can be read by nobody, as with some macros; no text,
        and why, where that is so of what the file holds.
    """
    first, last = read_urdf(before).description, read_urdf(new).description
    if first is None or last is None:
        return None
    if read_urdf(present).description is None:
        return MergedText(None, "it holds no robot that can be read")
    changed = edited(present, first, last, path)
    reason = "; ".join(each.message for each in changed.diagnostics)
    return MergedText(changed.text, reason)
