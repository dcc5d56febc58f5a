"""Reading the packages that a program loads to change them."""

from __future__ import annotations

import os
from contextlib import suppress
from dataclasses import dataclass, field
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias

from plastron_tui.diagnostics import Code, Diagnostic, codes
from plastron_tui.model.package_source import LoadedPackage
from plastron_tui.regular_files import Stamp, read_regular, reason, stamp_of
from plastron_tui.sources.packages.files import BUILD_FILES, MOST_FILES, package_files
from plastron_tui.sources.packages.reading import PACKAGE_XML, PackageFiles, read_package_files

from .missing_files import missing

if TYPE_CHECKING:
    from plastron_tui.boundary import Boundary

_TEXTS = frozenset(
    {
        "", ".action", ".c", ".cc", ".cfg", ".cmake", ".cpp", ".cxx", ".h", ".hh", ".hpp", ".in",
        ".launch", ".msg", ".py", ".srv", ".toml", ".txt", ".xml", ".xacro", ".yaml", ".yml",
    }
)  # fmt: skip
"""What may name a package, or a file of this one; without an ending there are scripts."""

_MOST_BYTES = 16_000_000
_LARGEST_BUILD_FILE = 4_000_000
"""In bytes; what is larger than a parser takes it says itself."""
_LARGEST_TEXT = 500_000


_MOST_PACKAGES = 16
"""How many are remembered; a program changes one or two."""

Stamps: TypeAlias = dict[str, Stamp | None]
"""The files of a package by their paths in it, each with its stamp."""

KnownPackages: TypeAlias = dict[tuple[Path, int], tuple[Stamps, LoadedPackage]]
"""What was read of packages, by folder and generation of ROS."""


class PackageReader:
    """Reads packages by the paths of their folders from the program's, within the project."""

    def __init__(self, folder: Path, boundary: Boundary, known: KnownPackages) -> None:
        """Set where folders are looked for.

        Args:
            folder: the program's folder.
            boundary: the project, which no `load_package` leaves unless it is trusted.
            known: what earlier readers have read; it counts until a file has another stamp.
        """
        self._folder = folder
        self._boundary = boundary
        self._known = known

    def __call__(self, source: str, ros_version: int) -> LoadedPackage:
        """Read the folder that a `load_package` asks for."""
        if "\0" in source:
            return _failed(codes.FILE_NOT_FOUND, "a path holds no NUL character")
        folder = self._folder / os.path.expanduser(source)  # noqa: PTH111 - as paths of nodes
        if not self._boundary.allows(folder):
            message = f"`{source}` is {self._boundary.place_of(folder)}"
            return _failed(codes.OUTSIDE_PROJECT, message, self._boundary.remedy)
        # A path that is too long is not there for these.
        if not os.path.isdir(folder):  # noqa: PTH112
            return _not_there(source, folder)
        place = Path(os.path.normpath(folder))
        key, stamps = (place, ros_version), _stamps(place)
        known = self._known.get(key)
        if known is None or known[0] != stamps:
            if len(self._known) >= _MOST_PACKAGES:
                self._known.clear()
            known = stamps, self._read(source, _Walk(place, self._boundary, stamps), ros_version)
            self._known[key] = known
        return known[1]

    def _read(self, source: str, files: _Walk, ros_version: int) -> LoadedPackage:
        problem = files.read()
        if problem is not None:
            return LoadedPackage(None, (problem,))
        if PACKAGE_XML not in files.texts:
            message = f"`{source}` has no `package.xml`: it is no package"
            return _failed(codes.FILE_NOT_FOUND, message)
        found = PackageFiles(
            files.folder, frozenset(files.names), files.texts, is_whole=files.is_whole
        )
        return read_package_files(found, ros_version)


@dataclass
class _Walk:
    """The files of a folder, read as far as they are of a size that people write."""

    folder: Path
    boundary: Boundary
    stamps: Stamps
    names: set[str] = field(default_factory=set)
    texts: dict[str, bytes] = field(default_factory=dict)
    is_whole: bool = True
    left: int = _MOST_BYTES

    def read(self) -> Diagnostic | None:
        """Read the files; the diagnostic says why one that has to be read is not."""
        for name in BUILD_FILES:
            path = self.folder / name
            if not os.path.lexists(path):
                continue
            if not self.boundary.allows(path):
                message = f"`{name}` is {self.boundary.place_of(path)}"
                return Diagnostic(codes.OUTSIDE_PROJECT, message, help=self.boundary.remedy)
            try:
                self.texts[name] = read_regular(path, _LARGEST_BUILD_FILE)
            except OSError as error:
                message = f"`{name}` cannot be read: {reason(error)}"
                return Diagnostic(codes.UNREADABLE_FILE, message)
        for name in self.stamps:
            if len(self.names) >= MOST_FILES:
                self.is_whole = False
                break
            self.names.add(name)
            if name not in self.texts and os.path.splitext(name)[1] in _TEXTS:  # noqa: PTH122
                self._take(name)
        return None

    def _take(self, name: str) -> None:
        path = self.folder / name
        text = None
        if self.boundary.allows(path):
            with suppress(OSError):
                text = read_regular(path, min(_LARGEST_TEXT, self.left))
        if text is None:
            self.is_whole = False
            return
        self.left -= len(text)
        self.texts[name] = text


def _stamps(folder: Path) -> Stamps:
    """Return the files of a package, with what tells whether one was changed."""
    names = islice(package_files(folder), MOST_FILES + 1)
    return {name: stamp_of(folder / name) for name in names}


def _not_there(source: str, folder: Path) -> LoadedPackage:
    if os.path.lexists(folder):
        return _failed(codes.FILE_NOT_FOUND, f"`{source}` is not a folder")
    remedy = missing(source, folder, Path.is_dir).remedy
    return _failed(codes.FILE_NOT_FOUND, f"no folder `{source}` beside the program", remedy)


def _failed(code: Code, message: str, remedy: str | None = None) -> LoadedPackage:
    return LoadedPackage(None, (Diagnostic(code, message, help=remedy),))
