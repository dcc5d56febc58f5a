"""The launch files that a program writes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.model.launch_checks import unwritable, with_parameter_files
from plastron_tui.model.launches import Launch, LaunchGeneration
from plastron_tui.model.workspace import Node, Workspace
from plastron_tui.sources.launch.new_elements import CannotWriteError
from plastron_tui.targets.launch.program import ExecutableName, request_of
from plastron_tui.targets.launch.python import write_python
from plastron_tui.targets.launch.xml import write_xml
from plastron_tui.targets.packages.spec import PackagedFile, PackagedLaunch, PackageFile

from .launch_files import edited_launch, executable_of, is_open, launch_output, needs_of_launch
from .own_package import homes_of, with_homes
from .package_parts import held_variables, is_within, name_within

if TYPE_CHECKING:
    from plastron_tui.diagnostics import Span
    from plastron_tui.model.packages import Package
    from plastron_tui.model.workspace import Generation
    from plastron_tui.output.plan import OutputFile
    from plastron_tui.ros.launch import LaunchFile

    from .apply_changes import Library
    from .destination import Writing
    from .generation import Generated
    from .text_files import Folder


class ProgramLaunches:
    """Makes the launch files of a program."""

    def __init__(
        self,
        workspace: Workspace,
        made: Sequence[Generated],
        generations: Sequence[Generation],
        libraries: Mapping[str, Library],
        default: Library | None,
        *,
        in_python: bool,
    ) -> None:
        """Set what they follow from.

        Args:
            workspace: what the program built.
            made: the files of its nodes.
            generations: all that the program generates, each with its place.
            libraries: the client libraries, by name.
            default: that of what no node tells the ROS of, None where nothing is known of it.
            in_python: whether launch files of ROS 2 are written in Python.
        """
        self._workspace = workspace
        self._homes = homes_of(made, generations)
        self._libraries = libraries
        self._default = default
        self._in_python = in_python

    def of_package(
        self, package: Package, version: int
    ) -> tuple[tuple[PackagedLaunch, ...], list[Diagnostic]]:
        """Return the launch files that a created package contains, and why others are missing."""
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

    def alone(self) -> Iterator[tuple[int, PackagedLaunch | Diagnostic]]:
        """Yield the launch files that are written for their own sake, with their ROS."""
        held = held_variables(self._workspace)
        last = {each.launch.variable: each.launch for each in self._workspace.written_launches}
        for variable, launch in last.items():
            if variable not in held and launch.source is None:
                version = self._version_of(launch)
                yield version, self._written(launch, version)

    def loaded(self, folder: Folder, writing: Writing) -> tuple[list[OutputFile], list[Diagnostic]]:
        """Return the launch files that the program loads and writes, as it changes them.

        One that a package contains is written with the package.
        """
        files: list[OutputFile] = []
        found: list[Diagnostic] = []
        last = {each.launch.variable: each for each in self._workspace.written_launches}
        held, homes = held_variables(self._workspace), dict[str, "Package"]()
        for package, variable, launch, where in self._contained():
            if is_within(package, launch):
                last[variable] = LaunchGeneration(launch, where)
                homes[variable] = package
        for variable, (launch, span) in last.items():
            if launch.source is None or (variable in held and variable not in homes):
                continue
            home = homes.get(variable)
            written = self._written(launch, launch.source.format.ros_version, home)
            if isinstance(written, Diagnostic):
                has_place = written.span is not None or written.file is not None
                found.append(written if has_place else written._replace(span=span))
                continue
            name = launch.source.path.name if home is None else name_within(home, launch)
            named = name, PackageFile(written.text)
            launch = with_parameter_files(self.placed(launch), home)
            file, notes = launch_output(launch, named, self.executable, folder, writing)
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
        for each, variable, launch, _ in self._contained():
            if each is package:
                written = self._written(launch, package.source.ros_version, package)
                if isinstance(written, Diagnostic):
                    problems.append(written)
                else:
                    found[variable] = written
        return found, tuple(problems)

    def _contained(self) -> Iterator[tuple[Package, str, Launch, Span]]:
        last = {each.package.variable: each.package for each in self._workspace.written_packages}
        for package in last.values():
            for variable, contained in package.contents.items():
                if isinstance(contained.item, Launch):
                    yield package, variable, contained.item, contained.span

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
        launch = self.placed(launch)
        for problem in unwritable(launch, version, home, self._workspace.packages):
            return problem
        launch = with_parameter_files(launch, home)
        named = self._named(launch, version)
        if isinstance(named, Diagnostic):
            return named
        name, text = named
        needs = needs_of_launch(launch, version)
        return PackagedLaunch(name, text, needs, is_open=is_open(launch))

    def _named(self, launch: Launch, version: int) -> tuple[str, bytes] | Diagnostic:
        """Return what a launch file is called, and its text."""
        if launch.source is not None:
            edited = edited_launch(launch, self.executable)
            return edited.diagnostics[0] if edited.text is None else (
                launch.source.path.name, edited.text
            )  # fmt: skip
        request = request_of(launch, version, self.executable)
        try:
            return self.written(launch.name, request.added, version)
        except CannotWriteError as problem:
            message = f"ROS {version} has no words for {problem} in a launch file"
            where = self._unspeakable(launch, version)
            return Diagnostic(codes.BAD_LAUNCH_NAME, message, where or launch.span)

    def written(self, stem: str, launch: LaunchFile, version: int) -> tuple[str, bytes]:
        """Return what a new launch file is called, and its text.

        Raises:
            CannotWriteError: this generation of ROS has no words for something in it.
        """
        is_python = self._in_python and version == 2
        text = write_python(launch) if is_python else write_xml(launch, version)
        suffix = ".launch.py" if is_python else ".launch.xml" if version == 2 else ".launch"
        return f"{stem}{suffix}", text.encode()

    def _unspeakable(self, launch: Launch, version: int) -> Span | None:
        """Return the first statement whose node cannot be written, None for none."""
        for start in launch.starts.values():
            alone = replace(launch, arguments={}, includes={}, starts={start.full_name: start})
            try:
                write_xml(request_of(alone, version, self.executable).added, version)
            except CannotWriteError:
                return start.span
        return None

    def placed(self, launch: Launch) -> Launch:
        """Return a launch file whose nodes are where the program's own packages have them."""
        return with_homes(launch, self._homes)

    def nodes_of(self, version: int) -> list[Node]:
        """Return the nodes of the program that are for a generation of ROS."""
        default = None if self._default is None else self._default.target.ros_version
        libraries = {name: each.target.ros_version for name, each in self._libraries.items()}
        nodes = self._workspace.nodes.values()
        return [x for x in nodes if libraries.get(x.library or "", default) == version]

    def executable(self, node: Node) -> ExecutableName:
        """Return what starts a node of a package."""
        library = self._libraries.get(node.library or "") or self._default
        return executable_of(node, None if library is None else library.target)


def configs(package: Package) -> tuple[PackagedFile, ...]:
    """Return the parameter files of a package's launch files."""
    launches = (each.item for each in package.contents.values() if isinstance(each.item, Launch))
    files = (file for launch in launches for file in launch.parameter_files)
    found = {each.path.name: PackagedFile(each.path.name, each.text, each.where) for each in files}
    return tuple(found.values())
