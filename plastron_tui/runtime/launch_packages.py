"""The packages around a launch file, and what starts their executables.

Sources: the ROS 2 documentation, "Using colcon to build packages" and "ROS 2 executables": an
executable of a package is installed as `lib/PACKAGE/EXECUTABLE`, its files in `share/PACKAGE`.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import NamedTuple

from plastron_tui.import_path import command
from plastron_tui.regular_files import read_regular
from plastron_tui.ros.installations import Origin
from plastron_tui.sources.launch.around import is_plain, packages_around, packages_root
from plastron_tui.sources.packages.folder import read_executables
from plastron_tui.sources.setup_py.reader import read_setup

from .environment import Environment

_LARGEST = 500_000

Variables = tuple[tuple[str, Path], ...]
"""Folders that are put before what a variable of the environment has."""


class Command(NamedTuple):
    """What starts an executable of a package.

    Attributes:
        command: the command line.
        folders: the folders that the process has to find besides, by variable.
    """

    command: tuple[str, ...]
    folders: Variables = ()


@dataclass(frozen=True, slots=True)
class Packages:
    """The packages that a launch file can start nodes of.

    Attributes:
        sources: the folder of each package whose sources are around the launch file.
        prefixes: where packages are installed: those of colcon first, then ROS itself.
        root: the folder that all sources are in.
    """

    sources: Mapping[str, Path]
    prefixes: tuple[Path, ...]
    root: Path

    def with_overlays(self, overlays: Iterable[Path]) -> Packages:
        """Return the same with folders in front in which packages are built."""
        return replace(self, prefixes=(*overlays, *self.prefixes))

    def share(self, package: str) -> str | None:
        """Return the folder that has a package's files, None where the package is not here.

        Sources have their files where the installed package has them (`launch`, `config`).
        """
        if package in self.sources:
            return str(self.sources[package])
        found = (each / "share" / package for each in self._prefixes_of(package))
        return next((str(each) for each in found if each.is_dir()), None)

    def has(self, file: Path) -> bool:
        """Tell whether a file is among the sources, or is installed."""
        path = Path(os.path.realpath(file))
        roots = (self.root, *self.prefixes)
        return any(path.is_relative_to(os.path.realpath(each)) for each in roots)

    def executable(self, package: str, name: str, python: Path) -> Command | None:
        """Return what starts an executable, None where it is not found."""
        if not is_plain(package) or not is_plain(name):
            return None
        if package in self.sources:
            found = self._of_sources(self.sources[package], name, python)
            if found is not None:
                return found
        for prefix in self._prefixes_of(package):
            path = prefix / "lib" / package / name
            if path.is_file() and os.access(path, os.X_OK):
                return Command((str(path),), tuple(_variables(prefix)))
        # What a package has yet to build is known by its name.
        known = read_executables(self.sources[package]) if package in self.sources else {}
        return Command((name,)) if name in known and known[name].sources else None

    def names(self, package: str, python: Path) -> list[str]:
        """Return the executables that a package is known to have."""
        found: list[str] = []
        folder = self.sources.get(package)
        if folder is not None:
            found += read_executables(folder)
            found += (each.name for each in _files(folder / "scripts"))
        for prefix in self._prefixes_of(package):
            found += (each.name for each in _files(prefix / "lib" / package))
        return list(dict.fromkeys(found))

    def _of_sources(self, folder: Path, name: str, python: Path) -> Command | None:
        paths = tuple(("PYTHONPATH", each) for each in self._python_folders(folder))
        known = read_executables(folder).get(name)
        if known is not None and ":" in known.target:
            return Command(tuple(command(known.target, str(python))), paths)
        files = [folder / known.file] if known is not None and known.file is not None else []
        if not (folder / "setup.py").exists():
            files += (x for x in _files(folder / "scripts") if x.name in (name, f"{name}.py"))
        for each in filter(Path.is_file, files):
            start = (str(python), str(each)) if _is_python(each) else (str(each),)
            if len(start) == 2 or os.access(each, os.X_OK):
                return Command(start, paths)
        return None

    def _python_folders(self, first: Path) -> Iterator[Path]:
        yield first / _python_root(first)
        for each in self.sources.values():
            if each != first and (each / "setup.py").is_file():
                yield each / _python_root(each)

    def _prefixes_of(self, package: str) -> Iterator[Path]:
        if not is_plain(package):
            return
        for prefix in self.prefixes:
            # `colcon build` gives each package a prefix of its own, unless told to merge them.
            yield prefix / package
            yield prefix


def find_packages(
    file: Path, environment: Environment, environ: Mapping[str, str] = os.environ
) -> Packages:
    """Find the packages around a launch file, and where others are installed.

    Around are those in the folder that `packages_root` tells, and the file's own.
    """
    file = Path.cwd() / file
    root = packages_root(file)
    beside = [each / "install" for each in (root, root.parent) if (each / "install").is_dir()]
    return Packages(packages_around(file, root), (*beside, *_prefixes(environment, environ)), root)


def _prefixes(environment: Environment, environ: Mapping[str, str]) -> Iterator[Path]:
    if environment.origin is Origin.SOURCED:
        for each in environ.get("AMENT_PREFIX_PATH", "").split(os.pathsep):
            if Path(each).is_absolute():
                yield Path(each)
    elif environment.origin is Origin.EXTRA:
        yield environment.python.parent.parent
    else:
        yield Path("/usr")


def _python_root(folder: Path) -> str:
    """Return the folder in a package that its Python packages are in, "" for its own."""
    try:
        source = read_regular(folder / "setup.py", _LARGEST)
    except (OSError, ValueError):
        return ""
    setup = read_setup(source, folder / "setup.py").setup
    root = None if setup is None else setup.root
    return "" if root is None or ".." in root.split("/") else root


def _files(folder: Path) -> list[Path]:
    try:
        return sorted(each for each in folder.iterdir() if each.is_file())
    except OSError:
        return []


def _is_python(file: Path) -> bool:
    try:
        head = read_regular(file, 10 * _LARGEST)[:200].split(b"\n")[0]
    except (OSError, ValueError):
        return False
    return file.suffix == ".py" or (head.startswith(b"#!") and b"python" in head)


def _variables(prefix: Path) -> Iterator[tuple[str, Path]]:
    version = f"python{sys.version_info.major}.{sys.version_info.minor}"
    for lib in (prefix / "lib" / version, *sorted((prefix / "lib").glob("python3*"))):
        if (lib / "site-packages").is_dir():
            yield "PYTHONPATH", lib / "site-packages"
            break
    if (prefix / "lib").is_dir():
        yield "LD_LIBRARY_PATH", prefix / "lib"
    yield "AMENT_PREFIX_PATH", prefix
