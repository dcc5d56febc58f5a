"""What keeps launch files from being written, once a program has come to its end."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import replace
from pathlib import Path

from plastron_tui.diagnostics import Diagnostic, Label, codes

from .launches import Launch, ParameterFile
from .libraries import ClientLibrary
from .packages import Package
from .workspace import Workspace

_CONFIG = "config"

VersionOf = Callable[[str | None], int]
"""Gives the generation of ROS of a client library, None for that of the program."""


def unwritable(
    launch: Launch,
    ros_version: int,
    home: Package | None,
    packages: Collection[str],
    own: Collection[str] = (),
) -> Iterator[Diagnostic]:
    """Yield what keeps a launch file from being written.

    Args:
        launch: the launch file.
        ros_version: the generation of ROS that it is for.
        home: the package that it is written into, None for none.
        packages: the variables of the program's packages.
        own: the variables of nodes that get a package of the program's own.
    """
    for start in launch.starts.values():
        variable = "" if start.node is None else start.node.variable
        if start.node is not None and start.node.home is None and variable not in own:
            yield Diagnostic(
                codes.IN_NO_PACKAGE,
                f"`{variable}` is in no package, and a launch file starts what packages have",
                start.where,
                help=_remedy(variable, packages),
            )
        if ros_version == 1 and start.container is not None and not start.is_loaded:
            message = "a launch file of ROS 1 has no containers of components"
            where = start.container_where
            help_ = f"leave out `inside '{start.container}'`: it runs in a process of its own"
            yield Diagnostic(codes.NOT_A_COMPONENT, message, where, help=help_)
    for file in launch.parameter_files:
        yield from _not_installed(launch, file, home)


def _remedy(variable: str, packages: Collection[str]) -> str:
    """Return how a node gets into a package."""
    if not packages:
        made = f"`create_package '{variable}_demo' as demo`"
        return f"make one, such as {made}, and put it in: `demo contains {variable}`"
    package = next(iter(packages)) if len(packages) == 1 else "PACKAGE"
    return f"put it into one: `{package} contains {variable}`"


def _not_installed(
    launch: Launch, file: ParameterFile, home: Package | None
) -> Iterator[Diagnostic]:
    name = file.path.name
    if home is None:
        yield Diagnostic(
            codes.IN_NO_PACKAGE,
            f"`{launch.variable}` is in no package that is written, which would install `{name}`",
            file.where,
            help=f"put it into one: `PACKAGE contains {launch.variable}`",
        )
    elif home.source is not None and _within(home.source.folder, file.path) is None:
        yield Diagnostic(
            codes.EDIT_REFUSED,
            f"`{name}` is not in `{home.name}`, and parameter files are not put into a package "
            "that is loaded",
            file.where,
            help=f"copy it to `{home.source.folder / _CONFIG / name}`, and name that",
        )


def with_parameter_files(launch: Launch, home: Package | None) -> Launch:
    """Return a launch file that finds its parameter files where a package installs them."""
    if home is None:
        return launch
    found = {}
    for name, start in launch.starts.items():
        file = start.parameters
        if file is not None:
            file = file._replace(package=home.name, inner=_inner(home, file))
        found[name] = start._replace(parameters=file)
    return replace(launch, starts=found)


def _inner(home: Package, file: ParameterFile) -> str:
    within = None if home.source is None else _within(home.source.folder, file.path)
    return within or f"{_CONFIG}/{file.path.name}"


def _within(folder: Path, path: Path) -> str | None:
    """Return the path of a file in a folder, None for one that is not in it."""
    return path.relative_to(folder).as_posix() if path.is_relative_to(folder) else None


def check_launches(
    workspace: Workspace, version_of: VersionOf, libraries: Mapping[str, ClientLibrary]
) -> Iterator[Diagnostic]:
    """Yield what keeps launch files from being written that a program writes.

    Args:
        workspace: what the program built.
        version_of: gives the generation of ROS of a client library.
        libraries: what is known of the client libraries, by name.
    """
    own = {
        each.node.variable
        for each in workspace.generations
        if each.library in libraries and libraries[each.library].is_built
    }
    written: dict[str, tuple[Launch, Package | None]] = {
        each.launch.variable: (each.launch, None) for each in workspace.written_launches
    }
    packages = {each.package.variable: each.package for each in workspace.written_packages}
    for package in packages.values():
        for variable, contained in package.contents.items():
            if isinstance(contained.item, Launch):
                written[variable] = contained.item, package
        yield from _same_names(package)
    for launch, home in written.values():
        version = _version(launch, version_of)
        yield from unwritable(launch, version, home, workspace.packages, own)


def _version(launch: Launch, version_of: VersionOf) -> int:
    if launch.source is not None:
        return launch.source.format.ros_version
    nodes = (each.node for each in launch.starts.values() if each.node is not None)
    return version_of(next((each.library for each in nodes), None))


def _same_names(package: Package) -> Iterator[Diagnostic]:
    """Yield an error for each second parameter file of a name: both would be one file."""
    there: dict[str, ParameterFile] = {}
    launches = (each.item for each in package.contents.values() if isinstance(each.item, Launch))
    for file in (each for launch in launches for each in launch.parameter_files):
        name = _inner(package, file)
        # Not every file system tells capitals from small letters.
        first = there.setdefault(name.lower(), file)
        if (first.path.name, first.text) != (file.path.name, file.text):
            yield Diagnostic(
                codes.BAD_PACKAGE_FILE,
                f"`{package.name}` gets another file as `{name}` already",
                file.where,
                help="give one of them another name",
                labels=(Label(first.where, "first here"),),
            )
