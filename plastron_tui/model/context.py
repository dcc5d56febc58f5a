"""What a program is interpreted in: client libraries, interface types, files to load."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.ros.robots.bodies import MeshBounds

from .launches import LaunchReader, ParameterReader, no_launch, no_parameters
from .libraries import Libraries
from .package_source import PackageReader, no_package
from .robots import RobotReader, no_robot

if TYPE_CHECKING:
    from .source import SourceUnit
    from .workspace import Generation


class LoadRequest(NamedTuple):
    """What a `load` asks for: a file by its bare name, or by a path from the program's folder.

    `generated` is what the program has asked to generate so far: a program may load what it
    generates.
    """

    source: str
    is_path: bool
    generated: tuple[Generation, ...]


class Loaded(NamedTuple):
    """What a reader made of a request.

    `source` is None when it could not read the file; `right` is then what a program writes to
    load the file that may be meant.
    """

    source: SourceUnit | None
    diagnostics: tuple[Diagnostic, ...] = ()
    right: str | None = None


class FoundDefinition(NamedTuple):
    """A definition file: where it is, what it holds, and what its folder and its name say."""

    path: Path
    text: bytes
    package: str
    kind: InterfaceKind


class LoadedDefinition(NamedTuple):
    """What a reader made of the path of a definition; None with the reason."""

    definition: FoundDefinition | None
    diagnostics: tuple[Diagnostic, ...] = ()


Reader = Callable[[LoadRequest], Loaded]
DefinitionReader = Callable[[str], LoadedDefinition]


def _no_definition(source: str) -> LoadedDefinition:
    found = Diagnostic(codes.FILE_NOT_FOUND, f"no file `{source}` beside the program")
    return LoadedDefinition(None, (found,))


def _no_mesh(uri: str) -> None:
    """Know no mesh: where a program has no folder, there is none."""


def _no_mesh_problem(uri: str) -> tuple[str, str | None]:
    """Know nothing of a mesh."""
    return "", None


Absent = Callable[[int, str], "Diagnostic | None"]
"""Says that a package of types is not installed in the ROS of a generation that is to run nodes."""


class Setting(NamedTuple):
    """What a program is interpreted in.

    Attributes:
        library: the client library of a node that names none.
        libraries: the client libraries that there are.
        catalog: gives the interface types for a generation of ROS.
        read: reads the files that the program loads.
        program: the name of the program's file without its ending, "" where it has none.
        read_definition: reads the definitions that the program loads.
        read_package: reads the packages that the program loads.
        read_launch: reads the launch files that the program loads.
        read_parameters: reads the parameter files that launch files name.
        read_robot: reads the robots that the program loads.
        mesh_bounds: tells the lowest and the highest corner of a mesh that a robot has.
        mesh_problem: says why that is not known, "" where it is, and what to do.
        is_chosen: whether somebody chose `library`; otherwise it is what there is on this machine.
        absent: says which packages of types are not installed, None where nobody wants to know.
    """

    library: str
    libraries: Libraries
    catalog: Callable[[int], Catalog]
    read: Reader
    is_chosen: bool = True
    program: str = ""
    read_definition: DefinitionReader = _no_definition
    read_package: PackageReader = no_package
    read_launch: LaunchReader = no_launch
    read_parameters: ParameterReader = no_parameters
    read_robot: RobotReader = no_robot
    mesh_bounds: MeshBounds = _no_mesh
    mesh_problem: Callable[[str], tuple[str, str | None]] = _no_mesh_problem
    absent: Absent | None = None

    def ros_version(self, library: str | None) -> int:
        """Return the generation of ROS of a client library; of the program's for one unknown."""
        if library is None or library not in self.libraries:
            library = self.library
        return self.libraries[library].ros_version
