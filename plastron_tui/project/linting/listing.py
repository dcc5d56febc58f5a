"""Which files of a folder count: those of packages, nodes, launch files and definitions.

As the build tools see it (`colcon` and `catkin`): folders with an ignore marker are left out, as
are those that builds leave behind, hidden ones, and whatever a link leads to.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path
from typing import NamedTuple

from plastron_tui.ros.packages import BUILT_FOLDERS, CACHES, IGNORE_MARKERS

MOST_FOLDERS = 20_000
MOST_FILES = 200_000
DEEPEST = 40
_MOST_ABOVE = 5
"""How many folders above a file its package may begin, for those who look for it."""

_LEFT_OUT = BUILT_FOLDERS | CACHES


class Listing(NamedTuple):
    """The files below a folder.

    Attributes:
        root: the folder that all of them are in.
        files: the files, as whole paths, in the order of their names.
        packages: the folders with a package.xml.
        inner: those of them that are in a package, which no build tool looks into for more; they
            are not among `packages`.
        left_out: the links that lead to a file or a folder, and the files that are ignored or
            excluded; none of them counts, yet code may name them.
        is_whole: whether nothing was left out for being too much.
    """

    root: Path
    files: tuple[str, ...]
    packages: tuple[str, ...]
    left_out: tuple[str, ...] = ()
    is_whole: bool = True
    inner: tuple[str, ...] = ()


def mark_of(path: str) -> str:
    """Return what tells something that is left out from another: a link with where it leads."""
    with suppress(OSError):
        return f"{path} -> {os.readlink(path)}"
    return path


def files_around(root: Path) -> tuple[str, ...]:
    """Return the files of the package that a folder is only a part of, none for no such package."""
    above = root.parents[:_MOST_ABOVE]
    package = next((each for each in above if (each / "package.xml").is_file()), None)
    return (
        () if package is None or (root / "package.xml").is_file() else list_files([package]).files
    )


class _Folder(NamedTuple):
    path: str
    depth: int = 0
    is_ignored: bool = False
    is_in_package: bool = False


class _Entries(NamedTuple):
    """What a folder has, each in the order of the names."""

    files: list[str]
    folders: list[str]
    links: list[str]
    names: set[str]


def _is_never(path: str) -> bool:
    del path
    return False


def list_files(paths: Sequence[Path], is_excluded: Callable[[str], bool] = _is_never) -> Listing:
    """List the files below folders; no link is followed, and what cannot be looked at is not there.

    Args:
        paths: the folders, whole and without links; a file among them counts itself.
        is_excluded: tells whether a file, or a folder with all below, is left out.
    """
    files: dict[str, None] = {}
    packages: dict[str, None] = {}
    inner: dict[str, None] = {}
    left_out: dict[str, None] = {}
    waiting = [_Folder(os.fspath(each)) for each in reversed(paths)]
    is_whole = True
    seen = 0
    while waiting:
        folder = waiting.pop()
        if not folder.depth and os.path.isfile(folder.path):
            files[folder.path] = None
            continue
        seen += 1
        here = _entries(folder.path)
        if seen > MOST_FOLDERS or len(files) + len(left_out) + len(here.files) > MOST_FILES:
            is_whole = False
            break
        is_ignored = folder.is_ignored or bool(here.names & IGNORE_MARKERS and folder.depth)
        for path in here.files:
            (left_out if is_ignored or is_excluded(path) else files)[path] = None
        left_out.update(dict.fromkeys(filter(os.path.exists, here.links)))
        if "package.xml" in here.names and f"{folder.path}/package.xml" in files:
            (inner if folder.is_in_package else packages)[folder.path] = None
        is_in_package = folder.is_in_package or (folder.path in packages and _is_built(here))
        if folder.depth < DEEPEST:
            waiting += [
                _Folder(each, folder.depth + 1, is_ignored or is_excluded(each), is_in_package)
                for each in reversed(here.folders)
            ]
    root = common_folder(paths)
    return Listing(root, tuple(files), tuple(packages), tuple(left_out), is_whole, tuple(inner))


def _is_built(here: _Entries) -> bool:
    """Tell whether a folder has what builds a package: one without is often there by mistake."""
    return not here.names.isdisjoint(("CMakeLists.txt", "setup.py"))


def common_folder(paths: Sequence[Path]) -> Path:
    """Return the folder that all paths are in, or that is one of them."""
    folders = [each if each.is_dir() else each.parent for each in paths]
    return Path(os.path.commonpath(folders))


def _entries(folder: str) -> _Entries:
    found = _Entries([], [], [], set())
    with suppress(OSError), os.scandir(folder) as entries:
        for entry in entries:
            name = entry.name
            if name.startswith("."):
                continue
            if entry.is_dir(follow_symlinks=False):
                if name not in _LEFT_OUT:
                    found.folders.append(entry.path)
            elif entry.is_file(follow_symlinks=False):
                found.files.append(entry.path)
            elif entry.is_symlink():
                found.links.append(entry.path)
            found.names.add(name)
    for paths in found[:3]:
        paths.sort()
    return found
