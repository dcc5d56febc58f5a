"""The other packages of the workspace that a file is in, as far as they have Python modules.

Whoever reads a whole workspace says which there are (`workspace_of`). For a file alone they are
looked for below the nearest folder above it that says how far its project reaches: a repository, a
folder `src`, or one with a project file. Without such a folder there are none.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from typing import NamedTuple

from plastron_tui.boundary import PROJECT_FILE
from plastron_tui.ros.packages import BUILT_FOLDERS, CACHES, IGNORE_MARKERS

Modules = Mapping[str, str]
"""The folder that has a module, by the name of the module."""

_MANIFEST = "package.xml"
_INIT = "__init__.py"
_MOST_ABOVE = 4
_MOST_BELOW = 4
_MOST_FOLDERS = 1000
_MOST_KNOWN = 8
_NOT_LISTED = BUILT_FOLDERS | CACHES

_GIVEN: ContextVar[Modules | None] = ContextVar("workspace", default=None)


class _Walked(NamedTuple):
    """What was found below a folder, and when each folder that was looked into had changed."""

    modules: Modules
    stamps: Mapping[str, int]


_WALKED: dict[str, _Walked] = {}


@contextmanager
def workspace_of(modules: Modules) -> Iterator[None]:
    """Let these be the modules of the workspace meanwhile, whatever file is read."""
    token = _GIVEN.set(modules)
    try:
        yield
    finally:
        _GIVEN.reset(token)


def modules_in(packages: Iterable[str], inits: Iterable[str]) -> Modules:
    """Return the modules that packages have in their folder, or in `src`; of two namesakes none.

    Args:
        packages: the folders of the packages.
        inits: the files `__init__.py` that there are.
    """
    owners = frozenset(packages)
    found: dict[str, set[str]] = {}
    for path in inits:
        module = os.path.dirname(path)  # noqa: PTH120
        folder, name = os.path.split(module)
        above, last = os.path.split(folder)
        if folder in owners or (last == "src" and above in owners):
            found.setdefault(name, set()).add(folder)
    return {
        name: folders.pop()
        for name, folders in sorted(found.items())
        if len(folders) == 1 and name.isidentifier() and name not in sys.stdlib_module_names
    }


def modules_around(root: str) -> Modules:
    """Return the modules of the workspace that a package is in.

    Args:
        root: the folder of the package, by its real path.
    """
    if not os.path.isfile(os.path.join(root, _MANIFEST)):  # noqa: PTH113, PTH118
        return {}
    given = _GIVEN.get()
    if given is not None:
        return given
    top = _top(root)
    return {} if top is None else _modules_below(top)


def _top(root: str) -> str | None:
    """Return the folder of the workspace, None where nothing above the package says so."""
    home = os.path.realpath(os.path.expanduser("~"))  # noqa: PTH111
    folder = root
    for _ in range(_MOST_ABOVE + 1):
        if f"{home}{os.sep}".startswith(f"{folder.rstrip(os.sep)}{os.sep}"):
            return None
        is_repository = os.path.lexists(os.path.join(folder, ".git"))  # noqa: PTH118
        is_project = os.path.isfile(os.path.join(folder, PROJECT_FILE))  # noqa: PTH113, PTH118
        if is_repository or is_project or os.path.basename(folder) == "src":  # noqa: PTH119
            return None if folder == root else folder
        folder = os.path.dirname(folder)  # noqa: PTH120
    return None


def _modules_below(top: str) -> Modules:
    known = _WALKED.get(top)
    if known is not None and all(_stamp(each) == at for each, at in known.stamps.items()):
        return known.modules
    packages: list[str] = []
    inits: list[str] = []
    stamps: dict[str, int] = {}
    waiting = [(top, 0)]
    while waiting and len(stamps) < _MOST_FOLDERS:
        folder, depth = waiting.pop()
        # Before it is looked into: what comes meanwhile counts as having come later.
        stamps[folder] = _stamp(folder)
        names, folders = _entries(folder)
        if depth and names & IGNORE_MARKERS:
            continue
        if _MANIFEST in names:
            packages.append(folder)
            stamps |= {each: _stamp(each) for each in folders}
            source = os.path.join(folder, "src")  # noqa: PTH118
            inner = _entries(source)[1] if source in folders else []
            stamps |= {each: _stamp(each) for each in inner}
            places = (os.path.join(each, _INIT) for each in (*folders, *inner))  # noqa: PTH118
            inits += filter(os.path.isfile, places)
        elif depth < _MOST_BELOW:
            waiting += [(each, depth + 1) for each in folders]
    while len(_WALKED) >= _MOST_KNOWN:
        _WALKED.pop(next(iter(_WALKED)))
    _WALKED[top] = _Walked(modules_in(packages, inits), stamps)
    return _WALKED[top].modules


def _entries(folder: str) -> tuple[set[str], list[str]]:
    """Return the names in a folder, and the folders among them that may have packages."""
    try:
        with os.scandir(folder) as entries:
            listed = [each for each in entries if not each.name.startswith(".")]
            names = {each.name for each in listed}
            inner = [each for each in listed if each.is_dir(follow_symlinks=False)]
    except OSError:
        return set(), []
    return names, sorted(each.path for each in inner if each.name not in _NOT_LISTED)


def _stamp(folder: str) -> int:
    try:
        return os.stat(folder).st_mtime_ns  # noqa: PTH116
    except OSError:
        return -1
