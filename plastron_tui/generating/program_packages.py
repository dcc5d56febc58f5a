"""The packages, definitions and launch files that a program writes besides its nodes."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Diagnostic, Label, codes
from plastron_tui.model.packages import SCRIPTS_FOLDER, nodes_folder
from plastron_tui.model.workspace import Workspace
from plastron_tui.ros.catalog.distributions import usual_distribution
from plastron_tui.targets.packages.rendering import (
    interfaces_of,
    node_paths,
    render_interfaces,
    render_package,
)
from plastron_tui.targets.packages.spec import (
    BuildType,
    PackagedLaunch,
    PackageFile,
    PackageSpec,
    interfaces_name,
)

from .loaded_types import refused_types
from .own_definitions import Packaged, own_definitions, rendered_definitions, used_packages
from .own_package import own_places, own_specs
from .package_parts import CompanionFinder, Copied, Parts, no_companions
from .package_spec import package_spec
from .program_launches import ProgramLaunches, configs
from .program_robots import ProgramRobots
from .robot_merges import merged_robot

if TYPE_CHECKING:
    from pathlib import Path

    from plastron_tui.model.packages import Package
    from plastron_tui.model.workspace import Generation
    from plastron_tui.output.merge3 import Merge

    from .apply_changes import Library
    from .generation import Generated


def _are_apart(spec: PackageSpec) -> bool:
    """Tell whether the nodes of a package leave its name to the module of its types."""
    folders = (nodes_folder(spec.name), SCRIPTS_FOLDER)
    homes = (each.node.home for each in spec.scripts)
    return all(home is not None and home.folder in folders for home in homes)


class Made(NamedTuple):
    """Files by their path in the output folder, and why others are missing.

    Attributes:
        files: what they hold.
        diagnostics: what there is to say.
        copies: the files that are copied as they are, where from.
        robots: those of the files that describe robots.
    """

    files: Mapping[str, PackageFile]
    diagnostics: tuple[Diagnostic, ...] = ()
    copies: Mapping[str, Copied] = {}
    robots: frozenset[str] = frozenset()

    @property
    def merges(self) -> dict[str, Merge]:
        """How those are merged with handwork that need not go by lines."""
        return dict.fromkeys(self.robots, merged_robot)


class ProgramPackages:
    """Makes what a program writes besides its nodes, as far as its nodes can be written."""

    def __init__(
        self,
        workspace: Workspace,
        made: Sequence[Generated],
        library_of: Callable[[str], Library | None],
        default: str,
        is_own: Callable[[Path], bool] = lambda _: False,
        *,
        generations: Sequence[Generation] = (),
        python_launch: bool = False,
        companions: CompanionFinder = no_companions,
    ) -> None:
        """Set what it follows from.

        Args:
            workspace: what the program built.
            made: the files of its nodes.
            library_of: gives a client library by its name, None for one that nothing writes.
            default: the client library of what no node tells the ROS of.
            is_own: tells whether an earlier run wrote a file.
            generations: all that the program generates, each with its place.
            python_launch: whether launch files of ROS 2 are written in Python.
            companions: finds what the descriptions of robots name.
        """
        self._workspace = workspace
        self._made = made
        self._is_own = is_own
        self._generations = generations
        names = dict.fromkeys((*(each.generation.library for each in made), default))
        found = {name: library_of(name) for name in names}
        self._libraries = {name: each for name, each in found.items() if each is not None}
        self._default = self._libraries.get(default) or next(iter(self._libraries.values()), None)
        self._definitions: dict[int, Packaged] = {}
        self.launches = ProgramLaunches(
            workspace,
            made,
            generations,
            self._libraries,
            self._default,
            in_python=python_launch,
        )
        self.robots = ProgramRobots(workspace, self.launches, companions)

    def made(self) -> Made:
        """Make the files."""
        own = list(own_specs(self._made, self._generations, self._libraries))
        alone = [] if own else list(self.robots.alone())
        files = dict(each for each in alone if not isinstance(each, Diagnostic))
        robots = set(files)
        diagnostics = [each for each in alone if isinstance(each, Diagnostic)]
        copies: dict[str, Copied] = {}
        if self._default is None:
            return Made(files, tuple(diagnostics), robots=frozenset(robots))
        last = {each.package.variable: each.package for each in self._workspace.written_packages}
        for part in (
            *(self._package(each) for each in last.values() if each.source is None),
            *self._own_packages(own),
            *self._definitions_alone(),
        ):
            files.update(part.files)
            copies.update(part.copies)
            robots |= part.robots
            diagnostics += part.diagnostics
        copies = {name: each for name, each in copies.items() if name not in files}
        return Made(files, tuple(dict.fromkeys(diagnostics)), copies, frozenset(robots))

    def of_loaded(self, package: Package) -> tuple[Parts, tuple[Diagnostic, ...]]:
        """Return what a loaded package gets besides nodes, and why something is missing."""
        assert package.source is not None, "it was loaded"
        version = package.source.ros_version
        of_ros = (x for x in self._libraries.values() if x.target.ros_version == version)
        known = next((x.catalog.distribution for x in of_ros), "") or usual_distribution(version)
        launches, problems = self.launches.of_loaded(package)
        robots = self.robots.of_package(package, version, known)
        return Parts(launches, robots.robots), (*problems, *robots.diagnostics)

    def _package(self, package: Package) -> Made:
        assert self._default is not None
        spec = package_spec(package, self._made, self._libraries, self._default)
        if spec is None:
            return Made({})
        definitions = self._own(spec.ros_version)
        home = package.name if spec.ros_version == 1 else interfaces_name(package.name)
        launches, problems = self.launches.of_package(package, spec.ros_version)
        robots = self.robots.of_package(package, spec.ros_version, spec.for_distribution)
        types = definitions.get(package.name, ())
        if types and spec.ros_version == 2 and not (spec.nodes or launches or robots.files):
            return self._types_alone(replace(spec, definitions=types))
        spec = replace(
            spec,
            launches=(*launches, *robots.launches),
            configs=configs(package),
            robots=robots.files,
            data=robots.folders,
        )
        if types and spec.ros_version == 2 and _are_apart(spec):
            spec = replace(spec, definitions=types, builds_types=True)
        else:
            spec = replace(spec, definitions=definitions.get(home, ()))
        rendered = render_package(spec)
        nodes = {path for each in spec.nodes for path in node_paths(spec, each)}
        files = {
            f"{spec.name}/{path}": file
            for path, file in (rendered.files or {}).items()
            if path not in nodes
        }
        found = [
            *problems,
            *robots.diagnostics,
            *rendered.diagnostics,
            *self._without_builder(spec),
        ]
        interfaces = interfaces_of(spec)
        made = {each.package.name for each in self._workspace.written_packages}
        if interfaces is not None and interfaces.name not in made:
            beside = render_interfaces(interfaces)
            files |= {
                f"{interfaces.name}/{path}": file for path, file in (beside.files or {}).items()
            }
        folder = f"{spec.name}/"
        return Made(files, tuple(found), robots.copies(folder), robots.paths(folder))

    def _own_packages(self, specs: Sequence[tuple[str, PackageSpec]]) -> Iterator[Made]:
        """Make the packages of nodes that have to be built, and are in none that is named.

        They install the robots, and the launch files of their generation, that are in no other
        package.
        """
        alone = list(self.launches.alone())
        places = own_places(self._generations, self._libraries)
        for version, written in alone:
            if isinstance(written, Diagnostic):
                yield Made({}, (written,))
            else:
                folder = f"{places[version]}launch/" if version in places else ""
                yield Made({f"{folder}{written.name}": PackageFile(written.text)})
        for folder, spec in specs:
            launches = (each for version, each in alone if version == spec.ros_version)
            held = (each for each in launches if isinstance(each, PackagedLaunch))
            robots = self.robots.of_own(spec)
            spec = replace(
                spec,
                launches=(*held, *robots.launches),
                robots=robots.files,
                data=robots.folders,
            )
            rendered = render_package(spec)
            nodes = {path for each in spec.nodes for path in node_paths(spec, each)}
            files = {
                f"{folder}{path}": file
                for path, file in (rendered.files or {}).items()
                if path not in nodes
            }
            found = (*robots.diagnostics, *rendered.diagnostics)
            yield Made(files, found, robots.copies(folder), robots.paths(folder))

    def _types_alone(self, spec: PackageSpec) -> Made:
        """Make a package that the program creates for nothing but types."""
        rendered = render_interfaces(replace(spec, build_type=BuildType.AMENT_CMAKE))
        files = {f"{spec.name}/{path}": file for path, file in (rendered.files or {}).items()}
        return Made(files, rendered.diagnostics)

    def _without_builder(self, spec: PackageSpec) -> Iterator[Diagnostic]:
        """Tell the types of a package of ROS 2 that are made after its nodes were placed."""
        if spec.ros_version == 1 or spec.builds_types:
            return
        for each in self._workspace.types.values():
            definition = each.definitions.get(spec.ros_version)
            package = definition.interface.name.package if definition is not None else ""
            if each.source is None and package == spec.name:
                yield Diagnostic(
                    codes.BAD_PACKAGE_FILE,
                    f"`{spec.name}/{each.name}` is of a package that is written further up "
                    "without types",
                    each.span,
                    help="make the type before `generate_package`",
                    labels=(Label(spec.span, "made here"),) if spec.span is not None else (),
                )

    def _own(self, version: int) -> Packaged:
        if version not in self._definitions:
            types = self._workspace.types.values()
            # A loaded type stays in its file; see `loaded_types`.
            created = (each for each in types if each.source is None)
            self._definitions[version] = own_definitions(created, version)
        return self._definitions[version]

    def _definitions_alone(self) -> Iterator[Made]:
        """Yield the packages of types that nodes use, or that are asked for, and no package has."""
        assert self._default is not None
        written = {each.package.name: each.package for each in self._workspace.written_packages}
        have = {name for name, each in written.items() if each.source is None}
        have |= {interfaces_name(name) for name in have}
        versions = {each.target.ros_version: each for each in self._libraries.values()}
        for version, library in versions.items():
            own = self._own(version)
            nodes = [
                each.generation.node
                for each in self._made
                if each.files is not None
                and self._libraries[each.generation.library].target.ros_version == version
            ]
            wanted = dict.fromkeys(used_packages(nodes, own))
            if version == self._default.target.ros_version:
                for name in self._workspace.written_types:
                    asked = self._workspace.types[name].definitions.get(version)
                    if asked is not None and asked.interface.name.package in own:
                        wanted[asked.interface.name.package] = None
            for package in (each for each in wanted if each not in have):
                if (
                    refused := refused_types(self._workspace, package, version, self._is_own)
                ) is not None:
                    yield Made({}, refused)
                    continue
                rendered = rendered_definitions(package, own, version, library.catalog.distribution)
                files = rendered.files or {}
                yield Made({f"{package}/{path}": file for path, file in files.items()})
