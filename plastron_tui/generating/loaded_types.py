"""The types of a program that belong to packages which it loads."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.model.own_types import Definition, OwnType
from plastron_tui.ros.definition import parse_definition
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName
from plastron_tui.targets.packages.spec import interfaces_name

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from pathlib import Path

    from plastron_tui.boundary import Boundary
    from plastron_tui.model.package_source import PackageSource
    from plastron_tui.model.workspace import Workspace


def types_of(workspace: Workspace, package: str, version: int) -> Iterator[OwnType]:
    """Yield the types that a program makes for a package, in a generation of ROS."""
    for each in workspace.types.values():
        definition = each.definitions.get(version)
        name = None if definition is None else definition.interface.name
        if each.source is None and name is not None and name.package == package:
            yield each


def places_beside(workspace: Workspace, boundary: Boundary) -> dict[str, Path]:
    """Return where the interface packages of loaded packages go with them, by their names.

    Args:
        workspace: what the program built.
        boundary: the project, which they do not leave.
    """
    return {
        interfaces_name(each.name): each.source.folder.parent
        for each in workspace.packages.values()
        if each.source is not None
        and each.source.ros_version == 2
        and boundary.allows(each.source.folder.parent)
    }


def refused_types(
    workspace: Workspace, package: str, version: int, is_own: Callable[[Path], bool]
) -> tuple[Diagnostic, ...] | None:
    """Say why no package is made for types; None where one is.

    A package that is loaded, or that stands beside one, is there: a second one of its name would
    hide it. With one that is written its types are.

    Args:
        workspace: what the program built.
        package: the package that the types are of.
        version: the generation of ROS.
        is_own: tells whether an earlier run wrote a file.
    """
    if any(each.package.name == package for each in workspace.written_packages):
        return ()
    for each in workspace.packages.values():
        source = each.source
        if source is None or source.ros_version != version:
            continue
        if each.name == package:
            why = f"`{package}` is loaded, and nothing writes it"
            help_ = f"write the package: `generate_package {each.variable}`"
        elif interfaces_name(each.name) == package and _is_there(source.folder, package, is_own):
            why = f"the folder `{package}` is there, beside that of `{each.name}`"
            help_ = f"load that package too, and write it: `load_package … as {package}`"
        else:
            continue
        return tuple(
            Diagnostic(
                codes.TYPE_NOT_WRITTEN, f"`{own.name}` is not written: {why}", own.span, help=help_
            )
            for own in types_of(workspace, package, version)
        )
    return None


def _is_there(folder: Path, package: str, is_own: Callable[[Path], bool]) -> bool:
    """Tell whether somebody's package is beside a folder."""
    place = folder.parent / package
    return os.path.lexists(place) and not is_own(place / "package.xml")


def types_of_run(workspace: Workspace, version: int) -> list[OwnType]:
    """Return the types in the packages that are built for a run: the program's, and others.

    A loaded package that is built with a type of the program's has its other types too, or it
    would hide them; one whose definition cannot be read is left out.

    Args:
        workspace: what the program built.
        version: the generation of ROS.
    """
    return [*workspace.types.values(), *_others(workspace, version)]


def _others(workspace: Workspace, version: int) -> Iterator[OwnType]:
    known = {
        (definition.interface.name, each.kind)
        for each in workspace.types.values()
        if (definition := each.definitions.get(version)) is not None
    }
    packages = {name.package for name, _ in known}
    for each in workspace.packages.values():
        source = each.source
        if source is None or source.ros_version != version or each.name not in packages:
            continue
        for kind, name, file in _definition_files(source):
            if (name, kind) in known:
                continue
            text = source.texts[file]
            read = parse_definition(text, name, kind, version, source.folder / file)
            if read.interface is not None:
                definitions = {version: Definition(text, read.interface)}
                yield OwnType(name.name, each.name, kind, each.span, definitions)


def _definition_files(
    source: PackageSource,
) -> Iterator[tuple[InterfaceKind, InterfaceName, str]]:
    for file in source.texts:
        folder, _, base = file.partition("/")
        name, _, ending = base.partition(".")
        for kind in InterfaceKind:
            if folder == ending == kind.value:
                yield kind, InterfaceName(source.name, name), file
