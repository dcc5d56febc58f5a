"""What is said of a file that a program names and that is not there."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics.suggest import nearest


class Missing(NamedTuple):
    """What stands where something is missing, as far as it is like it.

    Attributes:
        name: how the program would name it; None where nothing there is like it.
        remedy: what to say of that.
    """

    name: str | None
    remedy: str


def missing(source: str, path: Path, is_meant: Callable[[Path], bool]) -> Missing:
    """Look for what a program may mean by a path that leads to nothing.

    Args:
        source: the path as the program has it.
        path: where that is.
        is_meant: whether it could be this neighbour.
    """
    try:
        found_there = (each.name for each in path.parent.iterdir() if is_meant(each))
        # What has the name itself is no file that can be read: a pipe, or a link to nothing.
        names = sorted(each for each in found_there if each != path.name)
    except (OSError, ValueError):
        names = []
    found = nearest(path.name, names)
    if not found:
        return Missing(None, f"it is looked for as `{path}`")
    name = source[: len(source) - len(path.name)] + found
    return Missing(name, f"did you mean `{name}`?")
