"""The packages, definitions and launch files that a program writes besides its nodes."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Diagnostic, Label, codes
from plastron_tui.model.launch_checks import unwritable, with_parameter_files
from plastron_tui.model.launches import Launch, LaunchGeneration
from plastron_tui.model.packages import SCRIPTS_FOLDER, nodes_folder
from plastron_tui.model.workspace import Node, Workspace
from plastron_tui.sources.launch.new_elements import CannotWriteError
from plastron_tui.targets.launch.program import ExecutableName, request_of
from plastron_tui.targets.launch.python import write_python
from plastron_tui.targets.launch.xml import write_xml
from plastron_tui.targets.packages.rendering import (
    interfaces_of,
    node_paths,
    render_interfaces,
    render_package,
)
from plastron_tui.targets.packages.spec import (
    BuildType,
    PackagedFile,
    PackagedLaunch,
    PackageFile,
    PackageSpec,
    interfaces_name,
)

from .launch_files import (
    edited_launch,
    executable_of,
    is_open,
    is_within,
    launch_output,
    name_within,
    needs_of_launch,
)
from .loaded_types import refused_types
from .own_definitions import Packaged, own_definitions, rendered_definitions, used_packages
from .own_package import homes_of, own_places, own_specs, with_homes
from .package_spec import package_spec

if TYPE_CHECKING:
    from pathlib import Path

    from plastron_tui.diagnostics import Span
    from plastron_tui.model.packages import Package
    from plastron_tui.model.workspace import Generation
    from plastron_tui.output.plan import OutputFile

    from .apply_changes import Library
    from .destination import Writing
    from .generation import Generated
    from .text_files import Folder


def _are_apart(spec: PackageSpec) -> bool:
    """Tell whether the nodes of a package leave its name to the module of its types."""
    folders = (nodes_folder(spec.name), SCRIPTS_FOLDER)
    homes = (each.node.home for each in spec.scripts)
    return all(home is not None and home.folder in folders for home in homes)


class Made(NamedTuple):
    """Files by their path in the output folder, and why others are missing."""

    files: Mapping[str, PackageFile]
    diagnostics: tuple[Diagnostic, ...] = ()


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
        """
        self._workspace = workspace
        self._made = made
        self._is_own = is_own
        self._generations = generations
        self._homes = homes_of(made, generations)
        self._python_launch = python_launch
        names = dict.fromkeys((*(each.generation.library for each in made), default))
        found = {name: library_of(name) for name in names}
        self._libraries = {name: each for name, each in found.items() if each is not None}
        self._default = self._libraries.get(default) or next(iter(self._libraries.values()), None)
        self._definitions: dict[int, Packaged] = {}

    def made(self) -> Made:
        """Make the files."""
        files: dict[str, PackageFile] = {}
        diagnostics: list[Diagnostic] = []
        if self._default is None:
            return Made(files)
        last = {each.package.variable: each.package for each in self._workspace.written_packages}
        for part in (
            *(self._package(each) for each in last.values() if each.source is None),
            *self._own_packages(),
            *self._definitions_alone(),
        ):
            files.update(part.files)
            diagnostics += part.diagnostics
        return Made(files, tuple(dict.fromkeys(diagnostics)))

    def _package(self, package: Package) -> Made:
        assert self._default is not None
        spec = package_spec(package, self._made, self._libraries, self._default)
        if spec is None:
            return Made({})
        definitions = self._own(spec.ros_version)
        home = package.name if spec.ros_version == 1 else interfaces_name(package.name)
        launches, problems = self._launches(package, spec.ros_version)
        types = definitions.get(package.name, ())
        if types and spec.ros_version == 2 and not (spec.nodes or launches):
            return self._types_alone(replace(spec, definitions=types))
        spec = replace(spec, launches=launches, configs=_configs(package))
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
        found = [*problems, *rendered.diagnostics, *self._without_builder(spec)]
        interfaces = interfaces_of(spec)
        made = {each.package.name for each in self._workspace.written_packages}
        if interfaces is not None and interfaces.name not in made:
            beside = render_interfaces(interfaces)
            files |= {
                f"{interfaces.name}/{path}": file for path, file in (beside.files or {}).items()
            }
        return Made(files, tuple(found))

    def _own_packages(self) -> Iterator[Made]:
        """Make the packages of nodes that have to be built, and are in none that is named.

        They install the launch files of their generation that are in no other package.
        """
        alone = list(self._launches_alone())
        places = own_places(self._generations, self._libraries)
        for version, written in alone:
            if isinstance(written, Diagnostic):
                yield Made({}, (written,))
            else:
                folder = f"{places[version]}launch/" if version in places else ""
                yield Made({f"{folder}{written.name}": PackageFile(written.text)})
        for folder, spec in own_specs(self._made, self._generations, self._libraries):
            launches = (each for version, each in alone if version == spec.ros_version)
            held = (each for each in launches if isinstance(each, PackagedLaunch))
            spec = replace(spec, launches=tuple(held))
            rendered = render_package(spec)
            nodes = {path for each in spec.nodes for path in node_paths(spec, each)}
            files = {
                f"{folder}{path}": file
                for path, file in (rendered.files or {}).items()
                if path not in nodes
            }
            yield Made(files, rendered.diagnostics)

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

    def _launches(
        self, package: Package, version: int
    ) -> tuple[tuple[PackagedLaunch, ...], list[Diagnostic]]:
        launches: list[PackagedLaunch] = []
        problems: list[Diagnostic] = []
        for contained in package.contents.values():
            if isinstance(contained.item, Launch):
                written = self._written(contained.item, version, package)
                if isinstance(written, Diagnostic):
                    problems.append(written)
                else:
                    launches.append(written._replace(span=contained.span))
        return tuple(launches), problems

    def _launches_alone(self) -> Iterator[tuple[int, PackagedLaunch | Diagnostic]]:
        """Yield the launch files that are written for their own sake, with their ROS."""
        last = {each.launch.variable: each.launch for each in self._workspace.written_launches}
        for variable, launch in last.items():
            if variable not in self._held and launch.source is None:
                version = self._version_of(launch)
                yield version, self._written(launch, version)

    def loaded_launches(
        self, folder: Folder, writing: Writing
    ) -> tuple[list[OutputFile], list[Diagnostic]]:
        """Return the launch files that the program loads and writes, as it changes them.

        One that a package contains is written with the package.
        """
        files: list[OutputFile] = []
        found: list[Diagnostic] = []
        last = {each.launch.variable: each for each in self._workspace.written_launches}
        homes: dict[str, Package] = {}
        for package, variable, launch, where in self._contained_launches():
            if is_within(package, launch):
                last[variable] = LaunchGeneration(launch, where)
                homes[variable] = package
        for variable, (launch, span) in last.items():
            if launch.source is None or (variable in self._held and variable not in homes):
                continue
            home = homes.get(variable)
            written = self._written(launch, launch.source.format.ros_version, home)
            if isinstance(written, Diagnostic):
                has_place = written.span is not None or written.file is not None
                found.append(written if has_place else written._replace(span=span))
                continue
            name = launch.source.path.name if home is None else name_within(home, launch)
            named = name, PackageFile(written.text)
            launch = with_parameter_files(with_homes(launch, self._homes), home)
            file, notes = launch_output(launch, named, self._executable, folder, writing)
            files.append(file)
            found += notes
        return files, found

    def of_loaded(
        self, package: Package
    ) -> tuple[dict[str, PackagedLaunch], tuple[Diagnostic, ...]]:
        """Return the launch files that a loaded package contains, by variable."""
        assert package.source is not None
        found: dict[str, PackagedLaunch] = {}
        problems: list[Diagnostic] = []
        for each, variable, launch, _ in self._contained_launches():
            if each is package:
                written = self._written(launch, package.source.ros_version, package)
                if isinstance(written, Diagnostic):
                    problems.append(written)
                else:
                    found[variable] = written
        return found, tuple(problems)

    def _contained_launches(self) -> Iterator[tuple[Package, str, Launch, Span]]:
        last = {each.package.variable: each.package for each in self._workspace.written_packages}
        for package in last.values():
            for variable, contained in package.contents.items():
                if isinstance(contained.item, Launch):
                    yield package, variable, contained.item, contained.span

    @property
    def _held(self) -> set[str]:
        """The variables of what is in a package that is written."""
        packages = (each.package for each in self._workspace.written_packages)
        return {variable for package in packages for variable in package.contents}

    def _version_of(self, launch: Launch) -> int:
        """Return the generation of ROS that a launch file is for: that of what it starts."""
        assert self._default is not None
        for start in launch.starts.values():
            library = None if start.node is None else self._libraries.get(start.node.library or "")
            if library is not None:
                return library.target.ros_version
        return self._default.target.ros_version

    def _written(
        self, launch: Launch, version: int, home: Package | None = None
    ) -> PackagedLaunch | Diagnostic:
        """Write a launch file into a package, None for none, or say what it cannot say."""
        launch = with_homes(launch, self._homes)
        for problem in unwritable(launch, version, home, self._workspace.packages):
            return problem
        launch = with_parameter_files(launch, home)
        name_and_text = self._name_and_text(launch, version)
        if isinstance(name_and_text, Diagnostic):
            return name_and_text
        name, text = name_and_text
        needs = needs_of_launch(launch, version)
        return PackagedLaunch(name, text, needs, is_open=is_open(launch))

    def _name_and_text(self, launch: Launch, version: int) -> tuple[str, bytes] | Diagnostic:
        if launch.source is not None:
            edited = edited_launch(launch, self._executable)
            return edited.diagnostics[0] if edited.text is None else (
                launch.source.path.name, edited.text
            )  # fmt: skip
        request = request_of(launch, version, self._executable)
        is_python = self._python_launch and version == 2
        try:
            text = write_python(request.added) if is_python else write_xml(request.added, version)
        except CannotWriteError as problem:
            message = f"ROS {version} has no words for {problem} in a launch file"
            where = self._unspeakable(launch, version)
            return Diagnostic(codes.BAD_LAUNCH_NAME, message, where or launch.span)
        suffix = ".launch.py" if is_python else ".launch.xml" if version == 2 else ".launch"
        return f"{launch.name}{suffix}", text.encode()

    def _unspeakable(self, launch: Launch, version: int) -> Span | None:
        """Return the first statement whose node cannot be written, None for none."""
        for start in launch.starts.values():
            alone = replace(launch, arguments={}, includes={}, starts={start.full_name: start})
            try:
                write_xml(request_of(alone, version, self._executable).added, version)
            except CannotWriteError:
                return start.span
        return None

    def _executable(self, node: Node) -> ExecutableName:
        library = self._libraries.get(node.library or "") or self._default
        return executable_of(node, None if library is None else library.target)


def _configs(package: Package) -> tuple[PackagedFile, ...]:
    """Return the parameter files of a package's launch files."""
    launches = (each.item for each in package.contents.values() if isinstance(each.item, Launch))
    files = (file for launch in launches for file in launch.parameter_files)
    found = {each.path.name: PackagedFile(each.path.name, each.text, each.where) for each in files}
    return tuple(found.values())
