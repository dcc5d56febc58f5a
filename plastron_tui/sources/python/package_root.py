"""Where the package begins that a file is in."""

from __future__ import annotations

import os
from pathlib import Path

_MOST_ABOVE = 4
# What a package of ROS, or of Python, has in its folder.
_MARKS = ("package.xml", "setup.py", "pyproject.toml")


def root_of(main: str) -> str:
    """Return the folder of the package that a file is in: its own folder where none is marked."""
    own = Path(main).parent
    folders = (own, *own.parents)[:_MOST_ABOVE]
    home = Path(os.path.expanduser("~"))  # noqa: PTH111 (never raises)
    for folder in folders:
        if folder == home:
            break
        if any(os.path.isfile(folder / mark) for mark in _MARKS):  # noqa: PTH113
            return str(folder)
        if os.path.lexists(folder / ".git"):
            break
    return str(own)
