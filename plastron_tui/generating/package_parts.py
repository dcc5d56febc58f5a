"""What a program loads by itself, and a package that it loads has."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Span
from plastron_tui.model.launches import Launch
from plastron_tui.model.package_source import PackageSource
from plastron_tui.model.packages import Package
from plastron_tui.model.robots import Robot
from plastron_tui.model.workspace import Workspace
from plastron_tui.targets.packages.spec import PackagedFile, PackagedLaunch


class PackagedRobot(NamedTuple):
    """A robot in a package.

    Attributes:
        file: its description; None where that is changed where it is in the package.
        path: where its description is in the package.
        launch: what starts it.
        span: the statement that puts it there.
    """

    file: PackagedFile | None
    path: str
    launch: PackagedLaunch
    span: Span


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
