"""Where the package begins that a file is in."""

from __future__ import annotations

import os

_MOST_ABOVE = 4
# What a package of ROS, or of Python, has in its folder.
_MARKS = ("package.xml", "setup.py", "pyproject.toml")


def root_of(main: str) -> str:
    """Return the folder of the package that a file is in: its own folder where none is marked.

    It is asked whenever a file is read or changed, so that no path is made an object.

    Args:
        main: the file, by its real path.
    """
    own = folder = os.path.dirname(main)  # noqa: PTH120
    home = os.path.expanduser("~")  # noqa: PTH111
    for _ in range(_MOST_ABOVE):
        if folder == home:
            break
        if any(os.path.isfile(os.path.join(folder, mark)) for mark in _MARKS):  # noqa: PTH113, PTH118
            return folder
        above = os.path.dirname(folder)  # noqa: PTH120
        if above == folder or os.path.lexists(os.path.join(folder, ".git")):  # noqa: PTH118
            break
        folder = above
    return own
