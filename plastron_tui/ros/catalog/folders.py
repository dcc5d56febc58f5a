"""Definitions in folders: installed ROS packages, and the workspace's own."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from plastron_tui.regular_files import read_regular
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName
from plastron_tui.ros.packages import IGNORE_MARKERS

_KINDS = {kind.value: kind for kind in InterfaceKind}
_TYPE_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*")
_XML_COMMENT = re.compile(r"<!--.*?(?:-->|\Z)", re.DOTALL)
_XML_NAME = re.compile(r"<name>\s*([A-Za-z0-9_-]+)\s*</name>")
_MANIFESTS = frozenset({"package.xml", "manifest.xml"})
_LARGEST_MANIFEST = 1024 * 1024
_MOST_FOLDERS = 20_000
_DEEPEST = 12


def installed_folders(
    environ: Mapping[str, str], ros_version: int | None = None
) -> tuple[Path, ...]:
    """Return the folders in which a sourced ROS keeps its packages, the first searched first.

    They are the folders of `ROS_PACKAGE_PATH` (ROS 1) and the `share` folders of
    `AMENT_PREFIX_PATH` (ROS 2); only those of one generation when `ros_version` is given.
    """
    folders: list[Path] = []
    if ros_version in (None, 1):
        folders += [Path(entry) for entry in _entries(environ, "ROS_PACKAGE_PATH")]
    if ros_version in (None, 2):
        folders += [Path(entry, "share") for entry in _entries(environ, "AMENT_PREFIX_PATH")]
    return tuple(folder for folder in dict.fromkeys(folders) if folder.is_dir())


def _entries(environ: Mapping[str, str], variable: str) -> list[str]:
    entries = environ.get(variable, "").split(os.pathsep)
    return [entry for entry in entries if entry and "\0" not in entry]


def package_of(definition: Path) -> str:
    """Return the package of a definition file: that of the folder around `msg`, or its own."""
    folder = definition.absolute().parent
    return _package_name(folder.parent if folder.name in _KINDS else folder)


class TypeFolders:
    """The definition files in some folders, listed when first asked for."""

    def __init__(self, folders: Sequence[Path]) -> None:
        self._folders = tuple(folders)
        self._files: dict[InterfaceKind, dict[InterfaceName, Path]] | None = None
        self._by_bare: dict[InterfaceKind, dict[str, list[InterfaceName]]] = {}
        self._again: set[tuple[InterfaceKind, InterfaceName]] = set()

    def file(self, name: InterfaceName, kind: InterfaceKind) -> Path | None:
        """Return the file that defines an interface, None when no folder has one."""
        return self._listed()[kind].get(name)

    def is_twice(self, name: InterfaceName, kind: InterfaceKind) -> bool:
        """Tell whether several files define an interface, of which the first one counts."""
        return bool(self._listed()) and (kind, name) in self._again

    def names(self, kind: InterfaceKind) -> Sequence[InterfaceName]:
        """Return the names of the interfaces of a kind, in no order."""
        return tuple(self._listed()[kind])

    def by_bare(self, kind: InterfaceKind) -> Mapping[str, Sequence[InterfaceName]]:
        """Return the full names by bare name."""
        if kind not in self._by_bare:
            table: dict[str, list[InterfaceName]] = {}
            for name in self._listed()[kind]:
                table.setdefault(name.name, []).append(name)
            self._by_bare[kind] = table
        return self._by_bare[kind]

    def _listed(self) -> dict[InterfaceKind, dict[InterfaceName, Path]]:
        if self._files is None:
            self._files = {kind: {} for kind in InterfaceKind}
            for folder in self._folders:
                for package, kind, listing in _interface_folders(folder):
                    for name, file in _definitions(listing, kind):
                        known = self._files[kind].setdefault(InterfaceName(package, name), file)
                        if known != file:
                            self._again.add((kind, InterfaceName(package, name)))
        return self._files


def _definitions(folder: Path, kind: InterfaceKind) -> Iterator[tuple[str, Path]]:
    for entry in _children(folder):
        stem, suffix = os.path.splitext(entry.name)  # noqa: PTH122 - a Path for each is slow
        if suffix == f".{kind.value}" and _TYPE_NAME.fullmatch(stem):
            yield stem, folder / entry.name


def _interface_folders(root: Path) -> Iterator[tuple[str, InterfaceKind, Path]]:
    """Yield the `msg`, `srv` and `action` folders under a root, with their packages."""
    if root.name in _KINDS:
        yield _package_name(root.absolute().parent), _KINDS[root.name], root
        return
    # The packages of an installation are side by side, and share/ has much else to walk.
    deepest = 1 if root.name == "share" else _DEEPEST
    waiting = [(root, 0)]
    seen: set[tuple[int, int]] = set()
    while waiting and len(seen) < _MOST_FOLDERS:
        folder, depth = waiting.pop()
        children = _children(folder)
        names = {entry.name for entry in children}
        if names & IGNORE_MARKERS or not _is_first_visit(folder, seen):
            continue
        kinds = [name for name in _KINDS if name in names]
        if kinds and (depth or names & _MANIFESTS or root.name != "share"):
            package = folder.name if root.name == "share" else _package_name(folder.absolute())
            yield from ((package, _KINDS[name], folder / name) for name in kinds)
        if depth == 0 and root.name != "share":
            suffixes = {os.path.splitext(name)[1] for name in names}  # noqa: PTH122 - a Path is slow
            loose = [kind for name, kind in _KINDS.items() if f".{name}" in suffixes]
            package = _valid_package(_package_name(folder.absolute()))
            yield from ((package, kind, folder) for kind in loose)
        if names & _MANIFESTS or depth == deepest:
            continue
        below = [entry.name for entry in children if _is_walkable(entry)]
        waiting += [(folder / name, depth + 1) for name in sorted(below, reverse=True)]


def _is_walkable(entry: os.DirEntry[str]) -> bool:
    if entry.name.startswith((".", "__")) or entry.name in _KINDS:
        return False
    try:
        return entry.is_dir()
    except OSError:
        return False


def _is_first_visit(folder: Path, seen: set[tuple[int, int]]) -> bool:
    """Tell whether a folder is new; symbolic links can lead to one again."""
    try:
        status = folder.stat()
    except OSError:
        return False
    key = (status.st_dev, status.st_ino)
    if key in seen:
        return False
    seen.add(key)
    return True


def _children(folder: Path) -> list[os.DirEntry[str]]:
    """Return the entries of a folder, by name; none when it cannot be listed."""
    try:
        with os.scandir(folder) as entries:
            return sorted(entries, key=lambda entry: entry.name)
    except (OSError, ValueError):
        return []


def _valid_package(name: str) -> str:
    """Make a name that a ROS package can have: lower case, a letter first (REP 144)."""
    valid = re.sub(r"[^a-z0-9]+", "_", name.lower()).strip("_")
    return valid if valid[:1].isalpha() else f"package_{valid}".rstrip("_")


def _package_name(folder: Path) -> str:
    """Return a package's name: what its manifest says, else the name of its folder.

    The name stands in import lines: one that no package can have is made into one that it can.
    """
    try:
        text = read_regular(folder / "package.xml", _LARGEST_MANIFEST)
        manifest = text.decode("utf-8", "replace")
    except (OSError, ValueError):
        manifest = ""
    match = _XML_NAME.search(_XML_COMMENT.sub("", manifest))
    name = match[1] if match else folder.name
    return name if name.isascii() and name.isidentifier() else _valid_package(name)
