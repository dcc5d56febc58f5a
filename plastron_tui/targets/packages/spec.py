"""What a package holds, before it is files."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import Enum
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, Span
from plastron_tui.model.packages import SCRIPTS_FOLDER, nodes_folder
from plastron_tui.model.workspace import Node
from plastron_tui.ros.catalog.distributions import usual_distribution
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.ros.package_keys import PROPRIETARY
from plastron_tui.ros.packages import DEFAULT_VERSION, MAINTAINER_MISSING, Maintainer
from plastron_tui.sources.base import Language


class BuildType(str, Enum):
    """How a package is built, by what its `package.xml` or its author calls it."""

    CATKIN = "catkin"
    AMENT_PYTHON = "ament_python"
    AMENT_CMAKE = "ament_cmake"
    AMENT_CMAKE_PYTHON = "ament_cmake_python"


class PackagedNode(NamedTuple):
    """A node in a package.

    Attributes:
        executable: what `ros2 run PACKAGE EXECUTABLE` starts; in ROS 1 the file is started.
        module: the stem of its file.
        text: what the file holds.
        node: its name and endpoints.
        language: what it is written in.
        library: its client library.
        span: the statement that puts it there.
        others: the other files of its source, by their names from the folder of its file.
        plugin: the class that a manager or a container loads it as, None for a program.
        suffix: what its file ends in, "" for what a new one of its language does.
    """

    executable: str
    module: str
    text: bytes
    node: Node
    language: Language
    library: str
    span: Span | None = None
    others: tuple[tuple[str, bytes], ...] = ()
    plugin: str | None = None
    suffix: str = ""

    @property
    def file(self) -> str:
        """The name of its file."""
        return f"{self.module}{self.suffix or self.language.suffix}"

    @property
    def is_built(self) -> bool:
        """Whether the package builds it from its source."""
        return self.language.is_built

    @property
    def imports(self) -> frozenset[str]:
        """What its files need of others, as their language names it."""
        texts = (self.text, *(text for _, text in self.others))
        found = frozenset().union(*(self.language.imports(each) for each in texts))
        # A loaded node brings files along whose folder is called as the package they come from.
        own = [f"/{name}" for name, _ in self.others]
        return frozenset(x for x in found if not any(name.endswith(f"/{x}") for name in own))


class PackagedLaunch(NamedTuple):
    """A launch file in a package.

    Attributes:
        name: its name.
        text: what it holds.
        needs: the packages whose nodes or files it starts.
        span: the statement that puts it there.
        is_open: whether who starts it has to give it an argument.
    """

    name: str
    text: bytes
    needs: frozenset[str] = frozenset()
    span: Span | None = None
    is_open: bool = False


class PackagedFile(NamedTuple):
    """A file that a package installs as it is, such as one of parameters."""

    name: str
    text: bytes
    span: Span | None = None


class PackagedDefinition(NamedTuple):
    """An interface type of a package's own: `needs` are the packages of its fields' types."""

    kind: InterfaceKind
    name: str
    text: bytes
    needs: frozenset[str] = frozenset()

    @property
    def path(self) -> str:
        """Where the definition stands in its package, such as `msg/WheelSpeed.msg`."""
        return f"{self.kind.value}/{self.name}.{self.kind.value}"


@dataclass(frozen=True, slots=True)
class PackageSpec:
    """A package that is written new.

    Attributes:
        name: its name, which `check_package_name` takes.
        ros_version: the generation of ROS, 1 or 2.
        description: one line of text; "" where none was given.
        maintainer: who looks after it, None where the program does not say it.
        license: an SPDX identifier, or what stands for another license; None where the program
            does not say one.
        version: three numbers.
        distribution: the distribution of ROS that it is for.
        nodes: the nodes that it installs.
        launches: the launch files that it installs.
        configs: the files in its folder `config`.
        robots: the descriptions of robots, in its folder `urdf`.
        data: the folders with files beside those that it installs, such as `meshes/visual`.
        definitions: its types. In ROS 2 they are in a package of their own, see `interfaces_of`,
            unless it `builds_types`.
        packages: the packages with interface types that are known, to tell imports by.
        build_type: how it is built; None for the one that its contents ask for.
        builds_types: whether its types of ROS 2 are built with it, not in a package beside it.
        is_bare: whether it is no more than what builds its nodes, for nobody said what it is.
        span: the statement that creates it.
    """

    name: str
    ros_version: int
    description: str = ""
    maintainer: Maintainer | None = None
    license: str | None = None
    version: str = DEFAULT_VERSION
    distribution: str = ""
    nodes: tuple[PackagedNode, ...] = ()
    launches: tuple[PackagedLaunch, ...] = ()
    configs: tuple[PackagedFile, ...] = ()
    robots: tuple[PackagedFile, ...] = ()
    data: tuple[str, ...] = ()
    definitions: tuple[PackagedDefinition, ...] = ()
    packages: frozenset[str] = frozenset()
    build_type: BuildType | None = None
    builds_types: bool = False
    is_bare: bool = False
    span: Span | None = None

    @property
    def builds(self) -> BuildType:
        """How it is built."""
        if self.build_type is not None:
            return self.build_type
        if self.ros_version == 1:
            return BuildType.CATKIN
        if self.built:
            return BuildType.AMENT_CMAKE
        if self.builds_types:
            return BuildType.AMENT_CMAKE_PYTHON if self.nodes else BuildType.AMENT_CMAKE
        return BuildType.AMENT_PYTHON if self.nodes else BuildType.AMENT_CMAKE

    @property
    def built(self) -> tuple[PackagedNode, ...]:
        """The nodes that are built from their sources."""
        return tuple(each for each in self.nodes if each.is_built)

    @property
    def scripts(self) -> tuple[PackagedNode, ...]:
        """The nodes that are installed as they are."""
        return tuple(each for each in self.nodes if not each.is_built)

    @property
    def modules(self) -> str:
        """The folder of its Python modules; beside nodes that are built there are only scripts."""
        if self.ros_version == 1 or self.built:
            return SCRIPTS_FOLDER
        return nodes_folder(self.name) if self.builds_types else self.name

    @property
    def summary(self) -> str:
        """What it says of itself: a description has to be there (REP 149).

        It names nothing that comes and goes: it stands beside the version, which people change.
        """
        if self.description:
            return self.description.strip()
        if self.nodes:
            return f"Generated nodes of {self.name}"
        if self.definitions and not self.launches:
            return f"Interface types of {self.name}"
        if self.robots:
            return f"Description of {self.name}"
        return f"Launch files of {self.name}"

    @property
    def person(self) -> Maintainer:
        """Who its files name as its maintainer."""
        return self.maintainer or Maintainer(*MAINTAINER_MISSING)

    @property
    def licensed(self) -> str:
        """What its files name as its license."""
        return self.license or PROPRIETARY

    @property
    def for_distribution(self) -> str:
        """The distribution that it is for."""
        return self.distribution or usual_distribution(self.ros_version)


def interfaces_name(package: str) -> str:
    """Return the name of the package that has the types of a ROS 2 package.

    Source: the ROS 2 developer guide, "Package naming": interfaces are in a package of their own,
    of which the name ends in `_interfaces`, or in `_msgs` for messages alone.
    """
    return f"{package}_interfaces"


class PackageFile(NamedTuple):
    """What a file of a package holds, and whether it can be started."""

    text: bytes
    is_executable: bool = False


class RenderedPackage(NamedTuple):
    """The files of a package by path, or why there are none (`files` is then None)."""

    files: Mapping[str, PackageFile] | None
    diagnostics: tuple[Diagnostic, ...] = ()
