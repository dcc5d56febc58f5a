"""What was read of a workspace: its packages, the files of nodes, launch files, definitions."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property, wraps
from pathlib import Path
from types import MappingProxyType
from typing import NamedTuple, TypeVar, cast

from plastron_tui.diagnostics import Diagnostic, Span
from plastron_tui.model.code_facts import CodeFacts
from plastron_tui.model.package_facts import BuildFacts
from plastron_tui.model.package_source import InstalledExecutable
from plastron_tui.model.source import SourceEndpoint, SourceNode, place_of
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import Interface, InterfaceKind, InterfaceName
from plastron_tui.ros.launch_started import Resolved, Started
from plastron_tui.ros.parameter_blocks import ParameterBlock

from .namesakes import Workspaces, nearest


class UnitFacts(NamedTuple):
    """What the files of a node, or of several, say; their texts are not kept.

    Attributes:
        path: the main file.
        library: the client library.
        ros_version: the generation of ROS that it is for.
        nodes: the nodes, with their endpoints.
        code: what else the code does.
        package: the name of the package that it is in, "" for none.
        is_test: whether it is a test, which the robot does not run.
        is_unbuilt: whether no build takes it, so that it is no part of what runs.
    """

    path: Path
    library: str
    ros_version: int
    nodes: tuple[SourceNode, ...]
    code: CodeFacts = CodeFacts()
    package: str = ""
    is_test: bool = False
    is_unbuilt: bool = False

    @property
    def is_python(self) -> bool:
        """Whether the main file is in Python: a script may have no suffix."""
        return self.path.suffix in ("", ".py")

    def path_of(self, endpoint: SourceEndpoint) -> Path:
        """Return the file that has a call site."""
        return self.file(endpoint.file)

    def file(self, name: str) -> Path:
        """Return the file of a name of the set, "" for the main one."""
        return place_of(self.path, name) if name else self.path


class PackageFacts(NamedTuple):
    """A package of the workspace.

    Attributes:
        folder: where it is.
        name: what its package.xml calls it.
        ros_versions: the generations of ROS that it is for.
        executables: what it installs for people to start.
        build: what its files say of each other, None where that is not known.
        loaded: what a container or a manager loads of it, by its class.
    """

    folder: Path
    name: str
    ros_versions: tuple[int, ...]
    executables: Mapping[str, InstalledExecutable]
    build: BuildFacts | None = None
    loaded: Mapping[str, InstalledExecutable] = MappingProxyType({})


class LaunchFacts(NamedTuple):
    """A launch file that no other one of the workspace includes, and all that it starts.

    Attributes:
        path: the file.
        resolved: what it starts.
        ros_version: the generation of ROS that it is written for.
    """

    path: Path
    resolved: Resolved
    ros_version: int = 2


class SettingPlace(NamedTuple):
    """A parameter that a launch file sets, by the byte where the node begins that gets it."""

    file: str
    start: int
    name: str


class StartedPlace(NamedTuple):
    """What a launch file starts: the file, where the node begins there, and the word for it."""

    file: str
    start: int
    word: str


class Earlier(NamedTuple):
    """What the types of a workspace were at an earlier revision.

    Attributes:
        revision: what it is called.
        interfaces: the types that it defined.
        unchanged: the files of nodes that hold what they held.
        places: where the members of definitions stand that are not what they were, by their
            sections and names.
    """

    revision: str
    interfaces: Mapping[tuple[InterfaceKind, InterfaceName], Interface]
    unchanged: frozenset[Path] = frozenset()
    places: Mapping[Path, Mapping[tuple[int, str], Span]] = MappingProxyType({})


@dataclass(frozen=True, eq=False)
class SourceTree:
    """The packages, nodes and launch files of a workspace.

    Attributes:
        root: the folder that all of them are in.
        packages: by their names.
        units: the files of nodes.
        launches: what the launch files start.
        catalogs: the interface types, those of the workspace among them, by generation of ROS.
        parameter_files: what the parameter files of ROS 2 say.
        unstarted: the nodes that launch files of ROS 2 start only where they are given other
            arguments.
        unstarted_ros1: those of ROS 1, of which only the programs count.
        setting_places: where launch files name the parameters that they set, as far as known.
        started_places: where launch files name what the workspace lacks, as far as known.
        is_whole: whether nothing was left out, for being too much or for a problem.
        problems: the files that could not be read, and why.
        wrong: what is wrong with each package.xml that the build tools refuse, and with each
            launch file that is no XML.
        asked: the rules that were asked for by their own codes or names: some then tell of what
            may have its other side beyond the workspace.
        files: all files that are looked at, as whole paths.
        commented: those that may have comments which name rules.
        earlier: the types at the revision that they are compared with, None for none.
        namesakes: the folders of packages whose name several have, by that name.
    """

    root: Path
    packages: Mapping[str, PackageFacts] = field(default_factory=dict)
    units: tuple[UnitFacts, ...] = ()
    launches: tuple[LaunchFacts, ...] = ()
    catalogs: Mapping[int, Catalog] = field(default_factory=dict)
    parameter_files: Mapping[Path, tuple[ParameterBlock, ...]] = field(default_factory=dict)
    unstarted: tuple[Started, ...] = ()
    unstarted_ros1: tuple[Started, ...] = ()
    setting_places: Mapping[SettingPlace, Span] = field(default_factory=dict)
    started_places: Mapping[StartedPlace, Span] = field(default_factory=dict)
    is_whole: bool = True
    problems: tuple[tuple[Path, str], ...] = ()
    wrong: tuple[Diagnostic, ...] = ()
    asked: frozenset[str] = frozenset()
    files: tuple[str, ...] = ()
    commented: tuple[str, ...] = ()
    earlier: Earlier | None = None
    namesakes: Mapping[str, Mapping[Path, PackageFacts]] = field(default_factory=dict)

    def package(self, name: str, file: str | Path | None) -> PackageFacts | None:
        """Return the package that a file means by a name, None where there is none for sure."""
        several = self.namesakes.get(name)
        if several is None:
            return self.packages.get(name)
        folder = None if file is None else nearest(several, Path(file))
        return None if folder is None else several[folder]

    def package_of(self, unit: UnitFacts) -> PackageFacts | None:
        """Return the package that the files of a node are in."""
        return self.package(unit.package, unit.path)

    @cached_property
    def workspaces(self) -> Workspaces:
        """The workspaces that packages of one name keep apart."""
        return Workspaces(self.namesakes)

    def are_apart(self, one: Path, other: Path) -> bool:
        """Tell whether two files are of different workspaces, and so never of one robot."""
        if not self.namesakes:
            return False
        number_of = self.workspaces.number_of
        return self.workspaces.are_apart(number_of(one), number_of(other))

    @cached_property
    def every_package(self) -> tuple[PackageFacts, ...]:
        """The packages, each of those that share a name among them."""
        shared = (each for several in self.namesakes.values() for each in several.values())
        alone = (each for name, each in self.packages.items() if name not in self.namesakes)
        return (*alone, *shared)

    @cached_property
    def derived(self) -> dict[object, object]:
        """What was found out of the whole workspace, by what finds it: see `once_a_tree`."""
        return {}

    @cached_property
    def built(self) -> tuple[UnitFacts, ...]:
        """The files of nodes without those that no build takes."""
        return tuple(unit for unit in self.units if not unit.is_unbuilt)

    @cached_property
    def by_path(self) -> Mapping[Path, UnitFacts]:
        """The files of nodes, by the paths of their main files."""
        return {unit.path: unit for unit in self.units}


_Derived = TypeVar("_Derived")


def once_a_tree(find: Callable[[SourceTree], _Derived]) -> Callable[[SourceTree], _Derived]:
    """Let several rules ask for what is the same for all: it is found once, and goes with the tree.

    A cache beside the trees would keep the last one alive in a studio that has closed its files.
    """

    @wraps(find)
    def found(tree: SourceTree) -> _Derived:
        if find not in tree.derived:
            tree.derived[find] = find(tree)
        return cast(_Derived, tree.derived[find])

    return found
