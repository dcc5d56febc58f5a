"""What a program loads by itself, and a package that it loads has."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import NamedTuple, TypeAlias

from plastron_tui.diagnostics import Diagnostic, Span
from plastron_tui.model.launches import Launch
from plastron_tui.model.package_source import PackageSource
from plastron_tui.model.packages import Package
from plastron_tui.model.robots import Robot
from plastron_tui.model.workspace import Workspace
from plastron_tui.targets.packages.spec import PackagedFile, PackagedLaunch


class Companion(NamedTuple):
    """A file that a robot's description names, and that its package gets: a mesh, say.

    Attributes:
        path: where it stands in the package.
        file: where it is copied from; None for one that somebody has put into the package.
    """

    path: str
    file: Path | None


class Copied(NamedTuple):
    """A file that is copied into a package, and the statement that asks for it."""

    file: Path
    span: Span


class Companions(NamedTuple):
    """What a robot's description needs beside it.

    Attributes:
        files: the files that its package gets.
        packages: the other packages that have files which it names.
        diagnostics: what it names, and its package does not get.
    """

    files: tuple[Companion, ...] = ()
    packages: frozenset[str] = frozenset()
    diagnostics: tuple[Diagnostic, ...] = ()


CompanionFinder: TypeAlias = Callable[[Robot, str, Span], Companions]
"""Finds what a robot needs in a package of a name, where a statement puts it."""


def no_companions(_: Robot, __: str, ___: Span) -> Companions:
    """Find nothing: where a program has no folder, there is none."""
    return Companions()


class PackagedRobot(NamedTuple):
    """A robot in a package.

    Attributes:
        file: its description; None where that is changed where it is in the package.
        path: where its description is in the package.
        launch: what starts it.
        span: the statement that puts it there.
        companions: the files beside its description.
    """

    file: PackagedFile | None
    path: str
    launch: PackagedLaunch
    span: Span
    companions: tuple[Companion, ...] = ()


class Parts(NamedTuple):
    """What a program puts into a package besides nodes, by variable."""

    launches: Mapping[str, PackagedLaunch] = {}
    robots: Mapping[str, PackagedRobot] = {}


def held_variables(workspace: Workspace) -> set[str]:
    """Return the variables of what is in a package that is written."""
    packages = (each.package for each in workspace.written_packages)
    return {variable for package in packages for variable in package.contents}


def is_within(package: Package, item: Launch | Robot) -> bool:
    """Tell whether a launch file or a robot that is loaded is a loaded package's own."""
    return package.source is not None and _inner(package.source, item) is not None


def name_within(package: Package, item: Launch | Robot) -> str:
    """Return what such a file is called in the output folder."""
    assert package.source is not None
    return f"{package.name}/{_inner(package.source, item)}"


def _inner(package: PackageSource, item: Launch | Robot) -> str | None:
    if item.source is None:
        return None
    path = Path(os.path.realpath(item.source.path))
    folder = Path(os.path.realpath(package.folder))
    return path.relative_to(folder).as_posix() if path.is_relative_to(folder) else None
