"""The packages around a launch file, and the folder that they are in."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path

from plastron_tui.boundary import holds_home
from plastron_tui.regular_files import read_regular
from plastron_tui.ros.packages import BUILT_FOLDERS, CACHES, IGNORE_MARKERS
from plastron_tui.sources.xml.document import read_xml

_LARGEST = 500_000
_DEEPEST = 5
_MOST_FOLDERS = 4000
_NO_SOURCES = BUILT_FOLDERS | CACHES
_HIGHEST = 3
"""How far above the folder of a launch file's own package the search goes."""


def packages_root(file: Path) -> Path:
    """Return the folder that the packages around a launch file are in.

    It is the `src` folder of a workspace, else the repository, else the folder that the file's own
    package is in, beside others. Without a package of its own it is the file's folder.

    Args:
        file: the launch file, as a whole path.
    """
    own = own_package(file)
    root = file.parent if own is None else own.parent
    above = (root, *root.parents[:_HIGHEST])
    source = next((each for each in above if each.name == "src"), None)
    if source is not None or own is None:
        return source or root
    # A home folder that is a repository holds more than a workspace.
    repositories = (each for each in above if (each / ".git").exists() and not holds_home(each))
    return next(repositories, root)


def own_package(file: Path) -> Path | None:
    """Return the folder of the package that a launch file is in, None where it is in none."""
    return next((each for each in file.parents if (each / "package.xml").is_file()), None)


def packages_around(
    file: Path, root: Path, allows: Callable[[Path], bool] = lambda _: True
) -> dict[str, Path]:
    """Return the folders of the packages around a launch file, by the names in their package.xml.

    The package that the file is in and those beside it go before others of their names, and are
    there whatever the folder around them is called: a program's output folder may be `build`.

    Args:
        file: the launch file, as a whole path.
        root: the folder that all but these packages are in.
        allows: tells whether a package.xml may be read.
    """
    own = own_package(file)
    found: dict[str, Path] = {}
    for folder in (*(() if own is None else (own, *_beside(own))), *folders_below(root)):
        name = package_name(folder) if allows(folder / "package.xml") else None
        if name is not None:
            found.setdefault(name, folder)
    return found


def _beside(package: Path) -> list[Path]:
    """Return the folders with a package.xml beside a package, in the order of their names."""
    around = package.parent
    found: list[Path] = []
    if not holds_home(Path(os.path.realpath(around))):
        with suppress(OSError):
            found = sorted(each for each in around.iterdir() if _may_hold_sources(each.name))
    return [each for each in found[:_MOST_FOLDERS]
            if (each / "package.xml").is_file()
            and not any((each / marker).exists() for marker in IGNORE_MARKERS)]  # fmt: skip


def folders_below(root: Path) -> Iterator[Path]:
    """Yield the folders with a package.xml below one, by their names; no link is followed."""
    for seen, (place, folders, files) in enumerate(os.walk(root)):
        path = Path(place)
        if seen >= _MOST_FOLDERS:
            return
        if IGNORE_MARKERS.intersection(files):
            folders.clear()
        elif "package.xml" in files:
            # A package has no packages in it (REP 149 and the build tools).
            folders.clear()
            yield path
        elif len(path.relative_to(root).parts) >= _DEEPEST:
            folders.clear()
        folders[:] = sorted(filter(_may_hold_sources, folders))


def _may_hold_sources(folder: str) -> bool:
    return folder not in _NO_SOURCES and not folder.startswith(".")


def package_name(folder: Path) -> str | None:
    """Return the name of the package in a folder, None where there is none that can be read."""
    try:
        source = read_regular(folder / "package.xml", _LARGEST)
    except (OSError, ValueError):
        return None
    document = read_xml(source).document
    if document is None or document.root.name != "package":
        return None
    found = document.root.named("name")
    name = found[0].value.strip() if found else ""
    return name if is_plain(name) else None


def is_plain(name: str) -> bool:
    """Tell whether a name is one of a folder or a file, and no path."""
    return bool(name) and name not in (".", "..") and not any(x in name for x in "/\\\0")
