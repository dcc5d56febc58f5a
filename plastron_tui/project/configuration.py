"""What holds for a program besides its text: the options, its project, its ROS, and its types.

It is read when it is first asked for, and made anew when the user trusts the project, or no more.
"""

from __future__ import annotations

import sys
from collections.abc import Collection, Mapping
from dataclasses import replace
from functools import cached_property, partial
from pathlib import Path
from typing import TYPE_CHECKING

from plastron_tui.boundary import DEFAULT_OUTPUT, Boundary, find_boundary
from plastron_tui.diagnostics import Diagnostic
from plastron_tui.project.options import Options
from plastron_tui.project.ros_choice import (
    RosChoice,
    Said,
    Why,
    choose_distribution,
    choose_ros,
)
from plastron_tui.project.settings import (
    TRUST_CODES,
    Project,
    as_error,
    find_project,
    outside_definition,
    outside_output,
)
from plastron_tui.ros.installations import Origin
from plastron_tui.ros.installed_packages import InstalledPackages, installed_packages
from plastron_tui.targets import LIBRARIES

if TYPE_CHECKING:
    from plastron_tui.generating.apply_changes import Library
    from plastron_tui.model.context import Absent
    from plastron_tui.ros.catalog import Catalog


class Configuration:
    """The options of a program, and what they leave to the project file and the environment."""

    def __init__(self, folder: Path, options: Options, environ: Mapping[str, str]) -> None:
        """Set what is looked at; nothing is read before it is asked for.

        Args:
            folder: the program's folder.
            options: what the command line sets.
            environ: the environment variables that say which ROS is sourced.
        """
        self.folder = folder
        self.options = options
        self.environ = environ
        self._catalogs: dict[int, Catalog] = {}
        self._packages: dict[int, InstalledPackages | None] = {}
        self._libraries: dict[str, Library | None] = {}

    def anew(self) -> Configuration:
        """Return the same with nothing of it read yet."""
        return Configuration(self.folder, self.options, self.environ)

    @cached_property
    def boundary(self) -> Boundary:
        """How far the program's project reaches."""
        named = () if self.options.output is None else (self.options.output.absolute(),)
        return replace(find_boundary(self.folder), named=named)

    @cached_property
    def _project(self) -> tuple[Project, tuple[Diagnostic, ...]]:
        overruled = () if self.options.output is None else ("output",)
        return find_project(self.boundary, LIBRARIES, overruled)

    @property
    def project(self) -> Project:
        """What the project file says."""
        return self._project[0]

    @property
    def project_problems(self) -> tuple[Diagnostic, ...]:
        """What is wrong with the project file."""
        found = self._project[1]
        return tuple(map(as_error, found)) if self.options.is_writing else found

    @cached_property
    def ros(self) -> RosChoice:
        """The ROS of a node that names none, and why it is that one."""
        return choose_ros(self._said, LIBRARIES, self.environ)

    @property
    def _said(self) -> tuple[Said, ...]:
        options, project = self.options, self.project
        return (
            Said(Why.OPTION, options.target, options.distribution),
            Said(Why.PROJECT, project.target, project.distribution),
        )

    @property
    def output(self) -> Path:
        """The output folder."""
        return self.options.output or self.project.output or self.folder / DEFAULT_OUTPUT

    @property
    def writes_within(self) -> Path | None:
        """The folder that nothing is written outside of, None where the user named the output."""
        is_named = self.options.output is not None or self.project.output is not None
        return None if is_named or self.boundary.is_trusted else self.folder

    @property
    def refusals(self) -> tuple[Diagnostic, ...]:
        """What stands against writing as long as the user does not trust the project."""
        return tuple(as_error(each) for each in self._project[1] if each.code in TRUST_CODES)

    @property
    def output_problem(self) -> Diagnostic | None:
        """Why nothing is to be written to the output folder: nobody named it, and it leads out."""
        if self.options.output is not None or self.boundary.allows(self.output):
            return None
        return outside_output(self.output, self.boundary)

    def catalog(self, ros_version: int) -> Catalog:
        """Return the interface types of a generation of ROS."""
        catalog = self._catalogs.get(ros_version)
        if catalog is None:
            catalog = self._catalogs[ros_version] = self._new_catalog(ros_version)
        return catalog

    def _new_catalog(self, ros_version: int) -> Catalog:
        from plastron_tui.ros.catalog import Catalog, installed_folders

        distribution = choose_distribution(ros_version, self._said, self.environ)
        own = self.project.types or (self.folder,)
        installed = installed_folders(self.environ, ros_version)
        refusal = partial(outside_definition, folders=own, boundary=self.boundary)
        return Catalog(distribution, own, installed, refusal)

    @property
    def absent(self) -> Absent | None:
        """What says which packages of types are not installed, None where it is not asked for."""
        return self._absent if self.options.tells_absent else None

    def _absent(self, ros_version: int, package: str) -> Diagnostic | None:
        from plastron_tui.runtime.environment import Environment, missing_package

        here = self._installed(ros_version)
        catalog = self.catalog(ros_version)
        if here is None or here.has(package) or not catalog.has_package(package):
            return None
        origin, _, distribution = here.installation
        if origin is not Origin.SOURCED and catalog.table_package(package) is not None:
            return None  # it is built when a node is run
        environment = Environment(origin, ros_version, distribution, Path(sys.executable))
        return missing_package(environment, package)

    def _installed(self, ros_version: int) -> InstalledPackages | None:
        if ros_version not in self._packages:
            self._packages[ros_version] = installed_packages(ros_version, self.environ)
        return self._packages[ros_version]

    def type_problems(self, versions: Collection[int] = (1, 2)) -> tuple[Diagnostic, ...]:
        """Return what is wrong with definitions that were asked for, or since they were left.

        Args:
            versions: the generations of ROS that count; a type of one may be looked for in the
                other one only to say so.
        """
        catalogs = (self._catalogs[each] for each in versions if each in self._catalogs)
        problems = (found for catalog in catalogs for found in catalog.problems)
        # The catalogs of both generations of ROS may have asked for one definition.
        return tuple(dict.fromkeys(problems))

    def leave_type_problems(self) -> None:
        """Tell of a definition's mistakes again only when it is asked for again."""
        for catalog in self._catalogs.values():
            catalog.problems.clear()

    def library(self, name: str) -> Library | None:
        """Return what writes nodes for a client library, None where nothing here does."""
        if name not in self._libraries:
            from plastron_tui.generating.apply_changes import Library
            from plastron_tui.targets import find_target

            target = find_target(name, self.project.templates)
            if target is not None:
                target.set_layouts(self.project.layouts)
            self._libraries[name] = (
                None if target is None else Library(target, self.catalog(target.ros_version))
            )
        return self._libraries[name]
