"""Packages of one name: which of them a file means, and which files are of one workspace.

A repository may hold several workspaces, each with a package of a name: a course, the exercises of
which build on each other. What is near in folders belongs together.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from pathlib import Path

Choices = Mapping[str, Path]
"""Of which folder a file takes each package that several folders have, as far as that is clear."""


def nearest(folders: Iterable[Path], file: Path) -> Path | None:
    """Return the folder that shares most folders with a file, None where two share as many."""
    depths = [(len(os.path.commonpath((each, file))), each) for each in folders]
    most = max((depth for depth, _ in depths), default=0)
    found = [each for depth, each in depths if depth == most]
    return found[0] if len(found) == 1 else None


def are_apart(one: Choices, other: Choices) -> bool:
    """Tell whether two files are of different workspaces: they mean different packages by a name.

    What is built from both workspaces never runs together, for one hides the other's package.
    """
    return any(other.get(name, folder) != folder for name, folder in one.items())
