"""The files in a package's folder."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

from plastron_tui.ros.packages import BUILT_FOLDERS, CACHES

from .reading import CMAKE_LISTS, PACKAGE_XML, PYPROJECT, SETUP_CFG, SETUP_PY

BUILD_FILES = (PACKAGE_XML, SETUP_PY, SETUP_CFG, PYPROJECT, CMAKE_LISTS)
"""What says how a package is built, and what is installed of it."""

DEEPEST = 64
"""How many folders of a package a file may be in."""

MOST_FILES = 4_000
"""How many files of a package are known."""

_BUILT = BUILT_FOLDERS | CACHES


def package_files(folder: Path) -> Iterator[str]:
    """Yield the files of a package in a steady order, none of those of packages inside it."""
    for place, folders, names in os.walk(folder):
        inner = Path(place)
        is_other = inner != folder and PACKAGE_XML in names
        here = "" if inner == folder else f"{inner.relative_to(folder).as_posix()}/"
        folders[:] = (
            []
            if is_other or here.count("/") >= DEEPEST
            else sorted(each for each in folders if not each.startswith(".") and each not in _BUILT)
        )
        if not is_other:
            yield from (here + name for name in sorted(names) if not name.startswith("."))
