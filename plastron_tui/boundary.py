"""How far a project reaches: what a program may load, and where its project file may lead.

A program and its project file may come with a folder that somebody else made. What they name is
taken at their word inside the project alone; beyond it the user has to trust the project first.
All paths are compared without symbolic links.
"""

from __future__ import annotations

import os
import shlex
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path

from plastron_tui.trust import TrustStore, real_path

PROJECT_FILE = "plastron.yaml"
DEFAULT_OUTPUT = "output"

_REPOSITORY = ".git"
_INSTALLED = frozenset({"site-packages", "dist-packages"})


def _is_trusted(root: Path) -> bool:
    return root in TrustStore()


@dataclass(frozen=True)
class Boundary:
    """The project of a program.

    Attributes:
        root: its folder, without symbolic links.
        project_file: the project file that counts, None where there is none.
        is_home_or_above: whether it is the home folder, or one above. Such a folder is a project by
            accident: of it the files beside the program count, and the default output folder.
        named: folders that the command line names, which is the user's own word.
        trusts: tells whether the user trusts a project's folder.
    """

    root: Path
    project_file: Path | None = None
    is_home_or_above: bool = False
    named: tuple[Path, ...] = ()
    trusts: Callable[[Path], bool] = field(default=_is_trusted)

    @property
    def is_trusted(self) -> bool:
        """Whether the user trusts the project, now."""
        return self.trusts(self.root)

    def allows(self, path: Path) -> bool:
        """Tell whether a program or a project file may lead to a path."""
        return self.contains(path) or self._is_named(path) or self.is_trusted

    def contains(self, path: Path) -> bool:
        """Tell whether a path, which need not be there, is a part of the project.

        What is hidden is none (`.git` has hooks, `.venv` has modules), nor are installed packages.
        """
        parts = self._parts(path)
        return parts is not None and not _is_hidden_or_installed(parts)

    def place_of(self, path: Path) -> str:
        """Say where a path is that is no part of the project."""
        if self._parts(path) is None:
            return f"outside of the project `{self.root}`"
        return f"in a hidden folder, or among installed packages, of `{self.root}`"

    def _parts(self, path: Path) -> tuple[str, ...] | None:
        """Return the names that lead from the root to a path, None where it is outside."""
        try:
            parts = Path(os.path.realpath(path)).relative_to(self.root).parts
        except (OSError, ValueError):
            return None
        is_deep = len(parts) > 1 and parts[0] != DEFAULT_OUTPUT
        return None if self.is_home_or_above and is_deep else parts

    def _is_named(self, path: Path) -> bool:
        try:
            real = Path(os.path.realpath(path))
            return any(real.is_relative_to(os.path.realpath(each)) for each in self.named)
        except (OSError, ValueError):
            return False

    @property
    def remedy(self) -> str:
        """What a user does who trusts the project."""
        problem = TrustStore().problem()
        if problem is not None:
            return f"nothing counts as trusted, because {problem}"
        return f"if you trust `{self.root}`, say so with `{self.command}`"

    @property
    def command(self) -> str:
        """The command that trusts the project."""
        return f"plastron trust {shlex.quote(os.fspath(self.root))}"


def find_boundary(folder: Path) -> Boundary:
    """Find the project of a folder: the repository, else the folder of the project file.

    Without either it is the folder itself. The search goes upward to the root of a repository
    and ends below the home folder: what lies in the home folder counts for it alone.
    """
    start = real_path(folder)
    project_file = None
    for place in (start, *start.parents):
        ends_search = holds_home(place)
        if ends_search and place != start:
            break
        file = place / PROJECT_FILE
        # The functions of `os.path` take what may not be looked at for what is not there.
        if project_file is None and os.path.isfile(file):  # noqa: PTH113
            project_file = file
        if ends_search or os.path.exists(place / _REPOSITORY):  # noqa: PTH110
            return Boundary(place, project_file, ends_search)
    root = start if project_file is None else project_file.parent
    return Boundary(root, project_file)


def _is_hidden_or_installed(parts: tuple[str, ...]) -> bool:
    return any(part.startswith(".") or part in _INSTALLED for part in parts)


def holds_home(folder: Path) -> bool:
    """Tell whether a folder is the home folder, or one above it."""
    if folder == folder.parent:
        return True
    with suppress(RuntimeError):
        home = Path.home()
        return home.is_absolute() and real_path(home).is_relative_to(folder)
    return False


def belongs_to_another(file: Path) -> bool:
    """Tell whether a file, or the folder that it is in, belongs to another user."""
    owners = {os.lstat(file).st_uid, file.stat().st_uid, file.parent.stat().st_uid}
    return owners != {os.geteuid()}
