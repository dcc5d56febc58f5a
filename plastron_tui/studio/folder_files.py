"""The files below a folder: for who is to choose one of them."""

from __future__ import annotations

import os
from collections.abc import Callable, Container, Iterator
from contextlib import suppress
from itertools import islice
from pathlib import Path

MOST_FILES = 60
"""The most files that are listed."""

MOST_ENTRIES = 3000
"""The most entries of a folder that are looked at."""

DEEPEST = 3
_LEFT_OUT = frozenset({"node_modules", "__pycache__", "build", "install", "log", "venv"})


def path_text(path: Path, folder: Path) -> str:
    """Return a path as a program in a folder has it."""
    try:
        return path.relative_to(folder).as_posix()
    except ValueError:
        return os.path.relpath(path, folder)


def found_files(
    suffixes: Container[str],
    folder: Path,
    is_meant: Callable[[str], bool] = lambda name: True,
    *,
    levels: int = DEEPEST,
) -> tuple[Path, ...]:
    """Return the files below a folder that end in one of some ways, and whose names are meant."""
    found = (path for path in files_of(suffixes, folder, levels) if is_meant(path.name))
    return tuple(islice(found, MOST_FILES))


def files_of(suffixes: Container[str], folder: Path, levels: int = DEEPEST) -> Iterator[Path]:
    """Yield the files below a folder that end in one of some ways; what is built is left out.

    So is what is hidden, and what links lead to. `levels` is how many folders below each other
    are looked into.
    """
    try:
        entries = sorted(islice(os.scandir(folder), MOST_ENTRIES), key=lambda each: each.name)
    except OSError:
        return
    folders = []
    for entry in entries:
        if entry.name.startswith(".") or entry.name in _LEFT_OUT:
            continue
        with suppress(OSError):
            if entry.is_dir(follow_symlinks=False):
                folders.append(Path(entry.path))
            elif os.path.splitext(entry.name)[1] in suffixes and entry.is_file():  # noqa: PTH122
                yield Path(entry.path)
    for inner in folders if levels else ():
        yield from files_of(suffixes, inner, levels - 1)
