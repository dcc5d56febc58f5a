"""Packages among the sources around a launch file that its nodes need, and that are built.

Source: REP 149, for the dependencies of a package.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.regular_files import read_regular
from plastron_tui.sources.xml.document import read_xml

from .build_needs import missing_for_build, not_found
from .build_output import Progress
from .builds import BuiltPackage, overlay
from .environment import Environment, missing_packages

_LARGEST = 2_000_000
_MOST_FILES = 1000
_COMPILING = (b"add_executable", b"add_library")
_KINDS = ("msg", "srv", "action")
_DEPENDS = frozenset(("depend", "build_depend", "build_export_depend", "exec_depend", "run_depend"))


def with_built(
    environment: Environment,
    sources: Mapping[str, Path],
    started: Iterable[str],
    tell: Callable[[Progress], object],
    environ: Mapping[str, str] = os.environ,
) -> tuple[Environment, list[Diagnostic]]:
    """Return an environment with the packages that nodes need built, and what it lacks.

    Those are the ones with interface types, and those that compile something.

    Args:
        environment: what is to run the nodes.
        sources: the folder of each package whose sources are around the launch file.
        started: the packages that nodes are started of.
        tell: is told how far a build is.
        environ: the environment variables.
    """
    reached = _needed(sources, started)
    needed = [name for name in reached if _has_interfaces(sources[name])]
    compiled = frozenset(name for name in reached if _compiles(sources[name]))
    if not needed and not compiled:
        return environment, []
    built = compiled | frozenset(missing_packages(environment, needed, environ))
    packages = [
        _package(name, sources[name], is_compiled=name in compiled)
        for name in reached
        if name in built
    ]
    needs = (need for name in compiled for need in _depends(sources[name]))
    others = [need for need in needs if need not in built]
    missing = missing_for_build(environment, others, (), environ)
    if missing:
        return environment, [not_found(environment, missing)]
    return overlay(environment, packages, tell, environ)


def _needed(sources: Mapping[str, Path], started: Iterable[str]) -> list[str]:
    """Return packages among the sources, and those that they need: each behind what it needs."""
    found: dict[str, None] = {}
    seen: set[str] = set()
    waiting = [(name, False) for name in sorted(set(started), reverse=True)]
    while waiting:
        name, is_done = waiting.pop()
        if is_done:
            found[name] = None
        elif name in sources and name not in seen:
            seen.add(name)
            waiting.append((name, True))
            waiting += ((each, False) for each in _depends(sources[name]))
    return list(found)


def _depends(folder: Path) -> list[str]:
    try:
        document = read_xml(read_regular(folder / "package.xml", _LARGEST)).document
    except (OSError, ValueError):
        return []
    children = () if document is None else document.root.children
    return [each.value.strip() for each in children if each.name in _DEPENDS]


def _has_interfaces(folder: Path) -> bool:
    return any(True for kind in _KINDS for _ in (folder / kind).glob(f"*.{kind}"))


def _compiles(folder: Path) -> bool:
    """Tell whether a package builds programs or libraries."""
    try:
        text = read_regular(folder / "CMakeLists.txt", _LARGEST).lower()
    except (OSError, ValueError):
        return False
    return any(word in text for word in _COMPILING)


def _package(name: str, folder: Path, *, is_compiled: bool) -> BuiltPackage:
    files = {}
    executables = set()
    for path in _files(folder):
        try:
            files[path.relative_to(folder).as_posix()] = read_regular(path, _LARGEST)
        except (OSError, ValueError):
            continue
        if os.access(path, os.X_OK):
            executables.add(path.relative_to(folder).as_posix())
    return BuiltPackage(name, files, frozenset(executables), is_compiled=is_compiled)


def _files(folder: Path) -> Iterator[Path]:
    """Yield the files of a package, without hidden ones and those that links lead to."""
    count = 0
    for place, folders, files in os.walk(folder):
        folders[:] = sorted(each for each in folders if each[:1] != "." and each != "__pycache__")
        for name in sorted(files):
            path = Path(place) / name
            if name[:1] == "." or path.is_symlink():
                continue
            count += 1
            if count > _MOST_FILES:
                return
            yield path
