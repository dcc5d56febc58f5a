"""Which file a qualified name leads to: of the package that a file is in, or of another one."""

from __future__ import annotations

import os
from typing import NamedTuple

from plastron_tui.regular_files import observer
from plastron_tui.sources.workspace_modules import Modules, modules_around

from .package_root import root_of

_MOST_PARTS = 8
_SUFFIX = ".py"
_TYPES = ("msg", "srv", "action")


class Found(NamedTuple):
    """The file of a module, and the names that lead on from it."""

    path: str
    names: tuple[str, ...]


class ModuleFiles:
    """Where names lead that the files of a workspace import; each question is asked once."""

    def __init__(self, main: str, *, in_workspace: bool) -> None:
        """Begin with a file.

        Args:
            main: the file that is read, by its real path; no name leads to it.
            in_workspace: whether names may lead to other packages of the workspace.
        """
        self._main = main
        self._in_workspace = in_workspace
        self._root = root_of(main)
        self._around: Modules | None = None
        self._found: dict[tuple[str, str], Found | None] = {}
        self._is_own: dict[tuple[str, str], bool] = {}

    def is_current(self) -> bool:
        """Tell whether each question to the disk would be answered now as it was."""
        return (
            self._root == root_of(self._main)
            and (self._around is None or self._around == self._look_around())
            and all(self._is_there(*key) == known for key, known in self._is_own.items())
            and all(self._find(*key) == known for key, known in self._found.items())
        )

    def find(self, name: str, seen_from: str) -> Found | None:
        """Return the module that a qualified name leads to, None where it leads elsewhere.

        Args:
            name: the name.
            seen_from: the file that imports it.
        """
        key = name, os.path.dirname(seen_from)  # noqa: PTH120
        if not self._may_be_own(*key) and self._neighbour(name) is None:
            return None
        if key not in self._found:
            self._found[key] = self._find(*key)
        return self._found[key]

    def _may_be_own(self, name: str, folder: str) -> bool:
        first = name.partition(".")[0]
        if (first, folder) not in self._is_own:
            self._is_own[first, folder] = self._is_there(first, folder)
        return self._is_own[first, folder]

    def _is_there(self, module: str, folder: str) -> bool:
        """Whether a folder of modules has one of a name."""
        places = (os.path.join(each, module) for each in self._folders(folder))  # noqa: PTH118
        return any(
            os.path.isdir(place) or os.path.isfile(place + _SUFFIX)  # noqa: PTH112, PTH113
            for place in places
        )

    def _folders(self, folder: str) -> tuple[str, ...]:
        """Return where Python, or what a build makes of a package, has its modules."""
        scripts = os.path.dirname(self._main)  # noqa: PTH120
        sources = os.path.join(self._root, "src")  # noqa: PTH118
        # What another package has beside a file is found by its whole name alone.
        beside = (folder,) if self._is_in_root(folder) else ()
        return tuple(dict.fromkeys((*beside, scripts, self._root, sources)))

    def _look_around(self) -> Modules:
        return modules_around(self._root) if self._in_workspace else {}

    def _neighbour(self, name: str) -> str | None:
        """Return the folder of the workspace that has the first module of a name."""
        first, _, rest = name.partition(".")
        if self._around is None:
            self._around = self._look_around()
        # The types of a package are made by its build, wherever its other modules lie.
        is_type = rest.partition(".")[0] in _TYPES
        return None if is_type else self._around.get(first)

    def _find(self, name: str, folder: str) -> Found | None:
        bare = name.lstrip(".")
        parts = tuple(bare.split("."))
        if not all(map(str.isidentifier, parts)) or len(parts) > _MOST_PARTS:
            return None
        above = len(name) - len(bare)
        folders = self._folders(folder)
        other = None if above else self._neighbour(name)
        if above:
            folders = (os.path.normpath(os.path.join(folder, *[os.pardir] * (above - 1))),)  # noqa: PTH118
        elif other is not None:
            folders = (*folders, other)
        for start in folders:
            for count in range(len(parts), 0, -1):
                place = os.path.join(start, *parts[:count])  # noqa: PTH118
                for path in (place + _SUFFIX, os.path.join(place, "__init__.py")):  # noqa: PTH118
                    if self._is_file(path) and self._is_within(os.path.realpath(path)):
                        return Found(os.path.realpath(path), parts[count:])
        return None

    def _is_file(self, path: str) -> bool:
        is_file = os.path.isfile(path)  # noqa: PTH113
        tell = observer()
        if tell is not None and not is_file and not self._is_in_root(path):
            # When it comes, it is what the name leads to.
            tell(path, None, None)
        return is_file

    def _is_within(self, path: str) -> bool:
        return path != self._main and (self._is_in_root(path) or self._is_of_neighbour(path))

    def _is_in_root(self, path: str) -> bool:
        return path.startswith(self._root + os.sep) or path == self._root

    def _is_of_neighbour(self, path: str) -> bool:
        return any(
            path.startswith(os.path.join(folder, module) + os.sep)  # noqa: PTH118
            for module, folder in (self._around or {}).items()
        )
