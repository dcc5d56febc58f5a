"""Launch files: what starts nodes together."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.ros.launch import StartedNode, joined, names_of
from plastron_tui.ros.parameters import Setting

if TYPE_CHECKING:
    from plastron_tui.ros.launch import Format, LaunchFile

    from .source import TextOrigin
    from .workspace import Node


class LaunchSource(NamedTuple):
    """A launch file that exists.

    Attributes:
        path: where it is.
        text: what the program starts from: what the file holds, without what it wrote itself.
        format: what it is written in.
        launch: what that text says.
        origin: where the text comes from if it is not simply what the file holds.
    """

    path: Path
    text: bytes
    format: Format
    launch: LaunchFile
    origin: TextOrigin | None = None

    @property
    def present(self) -> bytes:
        """What the file holds."""
        return self.text if self.origin is None else self.origin.present


class LoadedLaunch(NamedTuple):
    """What a reader made of the path of a launch file; None with the reason."""

    source: LaunchSource | None
    diagnostics: tuple[Diagnostic, ...] = ()


LaunchReader = Callable[[str], LoadedLaunch]


def no_launch(source: str) -> LoadedLaunch:
    """Find no launch file: where a program has no folder, there is none."""
    found = Diagnostic(codes.FILE_NOT_FOUND, f"no file `{source}` beside the program")
    return LoadedLaunch(None, (found,))


class ParameterFile(NamedTuple):
    """A parameter file that a program lets a node have.

    Attributes:
        path: where it is.
        text: what it holds.
        where: its path, in the statement.
        package: the package that installs it, "" where that is not known yet.
        inner: where it is in that package.
    """

    path: Path
    text: bytes
    where: Span
    package: str = ""
    inner: str = ""


class LoadedParameters(NamedTuple):
    """What a reader made of the path of a parameter file; None with the reason."""

    path: Path | None
    text: bytes = b""
    diagnostics: tuple[Diagnostic, ...] = ()


ParameterReader = Callable[[str, int], LoadedParameters]


def no_parameters(source: str, ros_version: int) -> LoadedParameters:
    """Find no parameter file: where a program has no folder, there is none."""
    found = Diagnostic(codes.FILE_NOT_FOUND, f"no file `{source}` beside the program")
    return LoadedParameters(None, b"", (found,))


class Start(NamedTuple):
    """A `starts` of a program.

    Attributes:
        node: the program's node, None for one of another package.
        package: the package of another node, "" for a node of the program's.
        executable: what starts it, "" for a node of the program's: its package says.
        name: the name that it runs under, None for its own.
        namespace: its namespace, None where nothing is said.
        container: the container that it runs in, None for a process of its own.
        remaps: names of its own, and those that they get.
        settings: values of its parameters.
        parameters: a file with values of its parameters, None for none.
        span: the statement.
        where: what is started, in the statement.
        container_where: its container, there; None for none.
        remaps_where: the names that it remaps, there.
        settings_where: the parameters that it sets, there.
        is_loaded: whether it is a node of the program that another process loads.
    """

    node: Node | None
    package: str
    executable: str
    name: str | None
    namespace: str | None
    container: str | None
    remaps: tuple[tuple[str, str], ...]
    settings: tuple[tuple[str, Setting], ...]
    parameters: ParameterFile | None
    span: Span
    where: Span
    container_where: Span | None = None
    remaps_where: tuple[Span, ...] = ()
    settings_where: tuple[Span, ...] = ()
    is_loaded: bool = False

    @property
    def run_name(self) -> str:
        """Its name at run time; a component without one is called as its class is."""
        own = self.executable.rpartition("::")[2] if self.node is None else self.node.name
        return self.name or own

    @property
    def full_name(self) -> str:
        """What a program calls it by: its namespace and its name, without the first `/`."""
        return f"{joined('', self.namespace or '')}/{self.run_name}".lstrip("/")


class LaunchArgument(NamedTuple):
    """A `has_argument` of a program; without a default it has to be given."""

    name: str
    default: Setting | None
    span: Span


class Included(NamedTuple):
    """An `includes` of a program: a package, and the file in it.

    Attributes:
        package: the package.
        file: the file, as the program writes it.
        span: the statement.
        where: both, in the statement.
    """

    package: str
    file: str
    span: Span
    where: Span

    @property
    def path(self) -> str:
        """Where the file is in its package: with launch files, unless a folder is named."""
        return self.file if "/" in self.file else f"launch/{self.file}"


@dataclass(slots=True)
class Launch:
    """A launch file, as the program has it so far.

    Attributes:
        name: what it is called, without its ending.
        variable: the program's variable for it.
        span: the statement that created or loaded it.
        source: what a loaded one came from, None for one that was created.
        arguments: those that the program gave it, by name.
        starts: what the program lets it start, by their full names.
        includes: what the program lets it include, by `PACKAGE/FILE`.
        removed_arguments: what the program took out of its source, by the same names.
        removed_starts: likewise.
        removed_includes: likewise.
    """

    name: str
    variable: str
    span: Span
    source: LaunchSource | None = None
    arguments: dict[str, LaunchArgument] = field(default_factory=dict)
    starts: dict[str, Start] = field(default_factory=dict)
    includes: dict[str, Included] = field(default_factory=dict)
    removed_arguments: dict[str, Span] = field(default_factory=dict)
    removed_starts: dict[str, Span] = field(default_factory=dict)
    removed_includes: dict[str, Span] = field(default_factory=dict)

    @property
    def by_shortest_name(self) -> dict[str, Start]:
        """What the program lets it start, by the least that tells each from the others."""
        there = () if self.source is None else names_of(self.source.launch.items, StartedNode)
        names = Counter(name.rpartition("/")[2] for name in (*self.starts, *there))
        return {
            each.run_name if names[each.run_name] == 1 else name: each
            for name, each in self.starts.items()
        }

    @property
    def parameter_files(self) -> tuple[ParameterFile, ...]:
        """The parameter files that its nodes have."""
        found = (each.parameters for each in self.starts.values())
        return tuple(each for each in found if each is not None)

    def snapshot(self) -> Launch:
        """Return the launch file as it is now, untouched by what later statements do to it."""
        return replace(
            self,
            arguments=dict(self.arguments),
            starts=dict(self.starts),
            includes=dict(self.includes),
            removed_arguments=dict(self.removed_arguments),
            removed_starts=dict(self.removed_starts),
            removed_includes=dict(self.removed_includes),
        )


class LaunchGeneration(NamedTuple):
    """A `generate_launch`: the launch file as it was then."""

    launch: Launch
    span: Span
