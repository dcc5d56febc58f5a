"""The files in a package's folder, and which executables its build files make of them."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from itertools import islice
from pathlib import Path

from plastron_tui.model.package_source import InstalledExecutable
from plastron_tui.regular_files import read_regular
from plastron_tui.ros.packages import BUILT_FOLDERS, CACHES
from plastron_tui.sources.setup_py.reader import read_setup
from plastron_tui.sources.splices import line_number

from .reading import (
    CMAKE_LISTS,
    PACKAGE_XML,
    PYPROJECT,
    SETUP_CFG,
    SETUP_PY,
    PackageFiles,
    read_package_files,
)

BUILD_FILES = (PACKAGE_XML, SETUP_PY, SETUP_CFG, PYPROJECT, CMAKE_LISTS)
"""What says how a package is built, and what is installed of it."""

DEEPEST = 64
"""How many folders of a package a file may be in."""

MOST_FILES = 4_000
"""How many files of a package are known."""

_LARGEST = 500_000
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


def read_executables(
    folder: Path, allows: Callable[[Path], bool] = lambda _: True
) -> Mapping[str, InstalledExecutable]:
    """Return what a package installs for people to start, by what they start it by.

    Of one that is not followed these are the console scripts of its setup.py.

    Args:
        folder: the folder of the package.
        allows: whether a file may be read.
    """
    texts: dict[str, bytes] = {}
    for name in BUILD_FILES:
        path = folder / name
        with suppress(OSError, ValueError):
            if os.path.lexists(path) and allows(path):
                texts[name] = read_regular(path, _LARGEST)
    names = frozenset(islice(package_files(folder), MOST_FILES))
    if PACKAGE_XML in texts:
        source = read_package_files(PackageFiles(folder, names, texts, is_whole=False), 2).source
        if source is not None:
            return source.executables
    return dict(_scripts(folder, texts.get(SETUP_PY, b"")))


def _scripts(folder: Path, text: bytes) -> Iterator[tuple[str, InstalledExecutable]]:
    setup = read_setup(text, folder / SETUP_PY).setup
    if setup is None:
        return
    for each in setup.console_scripts:
        file = "/".join((setup.root or "", *each.target.partition(":")[0].split("."))) + ".py"
        line = line_number(text, each.span.start)
        yield each.name, InstalledExecutable(file.lstrip("/"), SETUP_PY, line, each.target)
