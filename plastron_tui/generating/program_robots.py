"""The descriptions of robots that a program writes, and what starts them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.model.packages import Contained, Package
from plastron_tui.model.robots import Robot, RobotGeneration
from plastron_tui.model.workspace import Workspace
from plastron_tui.ros.robots.description import Mesh
from plastron_tui.sources.launch.new_elements import CannotWriteError
from plastron_tui.targets.launch.program import request_of
from plastron_tui.targets.packages.rendering import URDF_FOLDER
from plastron_tui.targets.packages.spec import (
    PackagedFile,
    PackagedLaunch,
    PackageFile,
    PackageSpec,
)
from plastron_tui.targets.robots.launch import DescribedRobot, with_description

from .launch_files import needs_of_launch
from .package_parts import (
    CompanionFinder,
    Companions,
    Copied,
    PackagedRobot,
    held_variables,
    is_within,
    name_within,
    no_companions,
)
from .robot_files import robot_output, robot_text
from .robot_launches import robot_starts

if TYPE_CHECKING:
    from plastron_tui.diagnostics import Span
    from plastron_tui.output.plan import OutputFile

    from .destination import Writing
    from .program_launches import ProgramLaunches
    from .text_files import Folder


class PackagedRobots(NamedTuple):
    """The robots of a package by variable, and what is to be said of them."""

    robots: dict[str, PackagedRobot]
    diagnostics: tuple[Diagnostic, ...] = ()

    @property
    def files(self) -> tuple[PackagedFile, ...]:
        """Their descriptions."""
        return tuple(each.file for each in self.robots.values() if each.file is not None)

    def paths(self, folder: str) -> frozenset[str]:
        """Return where their descriptions are, of a package in a folder that ends in `/`."""
        return frozenset(f"{folder}{URDF_FOLDER}/{each.name}" for each in self.files)

    @property
    def launches(self) -> tuple[PackagedLaunch, ...]:
        """What starts them."""
        return tuple(each.launch for each in self.robots.values())

    @property
    def folders(self) -> tuple[str, ...]:
        """The folders of what they need beside their descriptions."""
        found = (each.path for robot in self.robots.values() for each in robot.companions)
        return tuple(dict.fromkeys(each.rpartition("/")[0] for each in found))

    def copies(self, folder: str) -> dict[str, Copied]:
        """Return what is copied for them, by the path in the output folder.

        Args:
            folder: that of the package, with its slash.
        """
        return {
            f"{folder}{each.path}": Copied(each.file, robot.span)
            for robot in self.robots.values()
            for each in robot.companions
            if each.file is not None
        }


class ProgramRobots:
    """Makes the robots of a program."""

    def __init__(
        self,
        workspace: Workspace,
        launches: ProgramLaunches,
        companions: CompanionFinder = no_companions,
    ) -> None:
        """Set what they follow from.

        Args:
            workspace: what the program built.
            launches: writes launch files.
            companions: finds what descriptions name.
        """
        self._workspace = workspace
        self._launches = launches
        self._companions = companions

    def alone(self) -> Iterator[tuple[str, PackageFile] | Diagnostic]:
        """Yield the robots that the program creates and writes for their own sake, by file."""
        for robot, span in self._alone():
            written = robot_text(robot)
            if written.text is not None:
                yield written.name, PackageFile(written.text)
            yield from _told_at(span, written.diagnostics)

    def _alone(self) -> Iterator[RobotGeneration]:
        held = held_variables(self._workspace)
        last = {each.robot.variable: each for each in self._workspace.written_robots}
        for variable, each in last.items():
            if variable not in held and each.robot.source is None:
                yield each

    def of_own(self, spec: PackageSpec) -> PackagedRobots:
        """Return the same for a package of the program's own, each with what starts it."""
        nodes = {each.node.variable: Contained(each.node, None, each.node.span)
                 for each in spec.nodes}  # fmt: skip
        robots: dict[str, PackagedRobot] = {}
        found: list[Diagnostic] = []
        for robot, span in self._alone():
            package = Package(spec.name, "", span, contents=nodes)
            made = self._packaged(robot, package, spec.ros_version, spec.for_distribution, span)
            found += made.diagnostics
            if made.robot is not None:
                robots[robot.variable] = made.robot
        return PackagedRobots(robots, tuple(found))

    def loaded(self, folder: Folder, writing: Writing) -> tuple[list[OutputFile], list[Diagnostic]]:
        """Return the robots that the program loads and writes, as it changes them.

        One that a package contains is written with the package.
        """
        files: list[OutputFile] = []
        found: list[Diagnostic] = []
        held = held_variables(self._workspace)
        homes: dict[str, Package] = {}
        last = {each.robot.variable: each for each in self._workspace.written_robots}
        for package, variable, robot, span in self._contained():
            if is_within(package, robot):
                last[variable] = RobotGeneration(robot, span)
                homes[variable] = package
        for variable, (robot, span) in last.items():
            if robot.source is None or (variable in held and variable not in homes):
                continue
            written = robot_text(robot)
            found += _told_at(span, written.diagnostics)
            if written.text is None:
                continue
            home = homes.get(variable)
            name = written.name if home is None else name_within(home, robot)
            file, notes = robot_output(robot, (name, PackageFile(written.text)), folder, writing)
            files.append(file)
            found += notes
            if home is None and not writing.in_place:
                found += _unbound(robot, span)
        return files, found

    def of_package(self, package: Package, version: int, distribution: str) -> PackagedRobots:
        """Return the robots that a package contains, each with what starts it."""
        robots: dict[str, PackagedRobot] = {}
        found: list[Diagnostic] = []
        for each, variable, robot, span in self._contained():
            if each is not package:
                continue
            made = self._packaged(robot, package, version, distribution, span)
            found += made.diagnostics
            if made.robot is not None:
                robots[variable] = made.robot
        return PackagedRobots(robots, tuple(found))

    def _packaged(
        self, robot: Robot, package: Package, version: int, distribution: str, span: Span
    ) -> _Packaged:
        written = robot_text(robot)
        if written.text is None:
            return _Packaged(None, tuple(_told_at(span, written.diagnostics)))
        is_there = is_within(package, robot)
        path = f"{URDF_FOLDER}/{written.name}"
        if is_there:
            path = name_within(package, robot).partition("/")[2]
        macros = None if robot.source is None else robot.source.macros
        given = () if robot.source is None else robot.source.arguments
        nodes = self._launches.nodes_of(version)
        starts = robot_starts(robot, package, nodes, self._workspace, span)
        launch = self._launches.placed(starts.launch)
        started = request_of(launch, version, self._launches.executable).added
        described = DescribedRobot(package.name, path, macros is not None, given)
        try:
            started = with_description(started, described, version, distribution)
            name, text = self._launches.written(robot.stem, started, version)
        except CannotWriteError as problem:
            message = f"ROS {version} has no words for {problem} in a launch file"
            return _Packaged(None, (Diagnostic(codes.BAD_LAUNCH_NAME, message, span),))
        beside = self._companions(robot, package.name, span)
        needs = {*needs_of_launch(launch, version), *beside.packages}
        needs |= {"xacro"} if macros is not None else set()
        file = None if is_there else PackagedFile(written.name, written.text, span)
        if is_there:
            beside = Companions()
        packaged = PackagedLaunch(name, text, frozenset(needs - {package.name}), span)
        made = PackagedRobot(file, path, packaged, span, beside.files)
        told = (*written.diagnostics, *starts.diagnostics, *beside.diagnostics)
        return _Packaged(made, told)

    def _contained(self) -> Iterator[tuple[Package, str, Robot, Span]]:
        last = {each.package.variable: each.package for each in self._workspace.written_packages}
        for package in last.values():
            for variable, contained in package.contents.items():
                if isinstance(contained.item, Robot):
                    yield package, variable, contained.item, contained.span


class _Packaged(NamedTuple):
    robot: PackagedRobot | None
    diagnostics: tuple[Diagnostic, ...]


def _told_at(span: Span, found: Iterable[Diagnostic]) -> Iterator[Diagnostic]:
    """Yield diagnostics; what stands in no file is told at a statement."""
    yield from (each if each.file else each._replace(span=each.span or span) for each in found)


def _unbound(robot: Robot, span: Span) -> Iterator[Diagnostic]:
    """Tell what a copy of a robot's file in the output folder names from beside it."""
    assert robot.source is not None, "the robot was loaded"
    macros = robot.source.macros
    named = [each.file for each in (() if macros is None else macros.includes)]
    for link in robot.description.links.values():
        bodies = (*link.visuals, *link.collisions)
        named += [each.shape.uri for each in bodies if isinstance(each.shape, Mesh)]
    for each in dict.fromkeys(named):
        if "://" in each or each.startswith(("$(find", "${", "/")):
            continue
        name = robot.source.path.name
        message = f"`{name}` names `{each}`, which is not beside the copy that is written"
        help_ = (
            "change it where it is, with `--in-place`, or put it into a package, which gets both"
        )
        yield Diagnostic(codes.NOT_COPIED, message, span, help=help_)
        return
