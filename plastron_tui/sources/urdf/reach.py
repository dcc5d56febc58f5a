"""Where the files are that a robot's description names, and how far it may lead.

Meshes are named by URIs (`package://`, `file://`), files that xacro includes by paths with
`$(find PACKAGE)` in front. Both lead into the project and into packages that are installed, and
nowhere else: links, `..` and whole paths are judged by where they end.
"""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import NamedTuple

from plastron_tui.boundary import Boundary
from plastron_tui.trust import real_path

_DEBIAN_SHARE = Path("/usr/share")
_PACKAGE = re.compile(
    r"(?:package://|\$\(find(?:-pkg-share)?\s+)([^/)\s]+)\)?(?:/(.*))?", re.DOTALL
)
_FOLDER = "$(dirname)/"
_FILE = "file://"
_SCHEME = re.compile(r"[A-Za-z][A-Za-z0-9+.-]*://")
_MANIFEST = "package.xml"

_SOURCE = "source the ROS, or the workspace, that has the package"
_BUILD = "if building the package puts it there, build it, and source the workspace"


class Place(NamedTuple):
    """Where a file is; without a path, why nobody knows, or may know.

    Attributes:
        path: the file, None for none.
        problem: what stands behind the name of the file: `is not there`.
        is_computed: whether only expanding tells where it is.
        is_absent: whether it may be there, and is not.
        remedy: what to do, None for what everybody knows.
    """

    path: Path | None
    problem: str = ""
    is_computed: bool = False
    is_absent: bool = False
    remedy: str | None = None


@dataclass(frozen=True, slots=True)
class Reach:
    """The project of a program, and the packages that are installed.

    Attributes:
        boundary: the project.
        packages: the folders of packages by their names: those of the project, and `developed`.
        shares: the folders that have the files of installed packages, each in a folder of its
            name, in the order in which they are searched; without symbolic links.
        developed: the folders of packages that a sourced ROS 1 takes from where they are
            developed, without symbolic links.
    """

    boundary: Boundary
    packages: Mapping[str, Path]
    shares: tuple[Path, ...]
    developed: frozenset[Path] = frozenset()

    def package(self, name: str) -> Path | None:
        """Return the folder of a package, None where it is not here."""
        return next(self._folders(name), None)

    def _folders(self, name: str) -> Iterator[Path]:
        """Yield where a package is: the project's own sources first, then what is installed."""
        if name in self.packages:
            yield self.packages[name]
        if not name or name in (".", "..") or any(each in name for each in "/\\\0"):
            return
        yield from (share / name for share in self.shares if _is_package(share / name))

    def installed(self, path: Path) -> Path | None:
        """Return where an installed package has a file that is not in its sources.

        A package may install a file elsewhere than its sources have it.
        """
        for name, folder in self.packages.items():
            if path.is_relative_to(folder):
                inner = path.relative_to(folder)
                found = (each / inner for each in self._folders(name) if each != folder)
                return next((each for each in found if os.path.isfile(each)), None)  # noqa: PTH113
        return None

    def allows(self, path: Path | str) -> bool:
        """Tell whether a file, where its path ends, is in the project or an installed package."""
        try:
            real = os.path.realpath(path)
        except (OSError, ValueError):
            return False
        if self.boundary.contains(Path(real)):
            return True
        below = Path(real)
        for folder in below.parents:
            if folder in self.developed or (folder in self.shares and _is_package(below)):
                return True
            below = folder
        return False

    def find(self, name: str, folder: Path) -> Place:
        """Return where a file is.

        Args:
            name: its URI or path, as a robot's description has it.
            folder: what a path without a package starts from.
        """
        if "\0" in name:
            return Place(None, "has a NUL character in it")
        rest = name
        package = _PACKAGE.fullmatch(name)
        if package is not None:
            place = self.package(package.group(1))
            if place is None:
                return Place(None, _no_package(package.group(1)), remedy=_SOURCE)
            folder, rest = place, package.group(2) or ""
        elif name.startswith(_FOLDER):
            rest = name.removeprefix(_FOLDER)
        elif name.startswith(_FILE):
            rest = name.removeprefix(_FILE)
            if rest.startswith("$(find"):
                return self.find(rest, folder)
        elif _SCHEME.match(name):
            return Place(None, "is of a kind of URI that is not looked for")
        if "${" in rest or "$(" in rest:
            return Place(None, "is computed", is_computed=True)
        path: Path | None = folder / rest
        # A path that is too long is not there.
        if not os.path.isfile(folder / rest):  # noqa: PTH113
            path = self.installed(folder / rest)
        if not self.allows(path or folder / rest):
            return Place(None, "is neither in the project nor in an installed package")
        if path is None:
            return Place(None, "is not there", is_absent=True, remedy=_BUILD if package else None)
        return Place(path)


def package_of(name: str) -> tuple[str, str] | None:
    """Return the package that a URI or a path starts with, and what follows; None for none."""
    found = _PACKAGE.fullmatch(name.removeprefix(_FILE) if "$(find" in name else name)
    return None if found is None else (found.group(1), found.group(2) or "")


def find_reach(boundary: Boundary, file: Path, environ: Mapping[str, str]) -> Reach:
    """Find how far a robot's file may lead; packages of the project are looked for.

    Args:
        boundary: the project.
        file: the robot's file, as a whole path, or one that would be beside it.
        environ: the environment variables that say which ROS is sourced.
    """
    from plastron_tui.ros.catalog.folders import installed_folders
    from plastron_tui.sources.launch.around import (
        folders_below,
        own_package,
        package_name,
        packages_around,
    )

    root = boundary.root
    if boundary.is_home_or_above:
        root = own_package(file) or file.parent
    packages = dict(packages_around(file, root, boundary.contains))
    installed = installed_folders(environ)
    # In `share` packages are side by side; people develop theirs in folders of folders.
    sources = (each for each in installed if each.name != "share")
    developed = tuple(folder for each in sources for folder in folders_below(each))
    for folder in developed:
        if (name := package_name(folder)) is not None:
            packages.setdefault(name, folder)
    shares = (real_path(each) for each in (*installed, Path(sys.prefix, "share"), _DEBIAN_SHARE))
    return Reach(
        replace(boundary, trusts=_trusts_nothing),
        packages,
        tuple(dict.fromkeys(shares)),
        frozenset(map(real_path, developed)),
    )


def _trusts_nothing(_: Path) -> bool:
    """Trust no folder: a project that is trusted may lead no farther than another one."""
    return False


def _is_package(folder: Path) -> bool:
    return os.path.isfile(folder / _MANIFEST)  # noqa: PTH113 - a path that is too long is none


def _no_package(name: str) -> str:
    return f"is of the package `{name}`, which is neither in the project nor installed"
