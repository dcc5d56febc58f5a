"""The definitions of a program's own types, by the package that each belongs to."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING

from plastron_tui.output.plan import OutputFile
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.targets.packages.rendering import render_interfaces, render_package
from plastron_tui.targets.packages.spec import PackagedDefinition, PackageSpec, RenderedPackage

if TYPE_CHECKING:
    from plastron_tui.model.own_types import OwnType
    from plastron_tui.model.workspace import Node

Packaged = Mapping[str, tuple[PackagedDefinition, ...]]
"""Definitions, by the name of their package."""


def own_definitions(types: Iterable[OwnType], version: int) -> Packaged:
    """Return the definitions of types in a generation of ROS; those it cannot have are left out.

    Args:
        types: the program's own types.
        version: the generation of ROS.
    """
    found: dict[str, tuple[PackagedDefinition, ...]] = {}
    for each in types:
        definition = each.definitions.get(version)
        if definition is None:
            continue
        name = definition.interface.name
        needs = {
            field.type.package
            for section in definition.interface.sections
            for field in section.fields
            if field.type.package is not None
        }
        packaged = PackagedDefinition(
            each.kind, name.name, definition.text, frozenset(needs - {name.package})
        )
        found[name.package] = (*found.get(name.package, ()), packaged)
    return found


def used_packages(nodes: Iterable[Node], definitions: Packaged) -> tuple[str, ...]:
    """Return the packages among these whose types nodes use, those that they need first.

    Args:
        nodes: the nodes.
        definitions: the program's own definitions, by package.
    """
    found: dict[str, None] = {}

    def add(package: str, above: tuple[str, ...] = ()) -> None:
        if package in found or package in above:
            return
        for each in definitions[package]:
            for need in sorted(each.needs & definitions.keys()):
                add(need, (*above, package))
        found[package] = None

    names: set[InterfaceName] = {type_ for node in nodes for type_ in node.types}
    for package in sorted({name.package for name in names} & definitions.keys()):
        add(package)
    return tuple(found)


def rendered_definitions(
    package: str, definitions: Packaged, version: int, distribution: str
) -> RenderedPackage:
    """Write the files of a package that has nothing but definitions.

    Args:
        package: its name.
        definitions: the program's own definitions, by package.
        version: the generation of ROS.
        distribution: the distribution that it is for.
    """
    spec = PackageSpec(
        package, version, distribution=distribution, definitions=definitions[package]
    )
    return render_package(spec) if version == 1 else render_interfaces(spec)


def loaded_definitions(types: Iterable[OwnType], *, in_place: bool) -> Iterator[OutputFile]:
    """Yield the files of types that a program loaded and changed.

    Elsewhere than in their places they go where those of types that are made do: below the folder
    of their package, in that of their kind. Two packages may have types of one name.

    Args:
        types: the program's own types.
        in_place: whether they are written over the files that they came from.
    """
    for each in types:
        if each.source is None or not each.is_changed:
            continue
        text = next(iter(each.definitions.values())).text
        path, held = each.source
        yield OutputFile(
            f"{each.package}/{each.kind.value}/{path.name}",
            text,
            is_executable=False,
            merged_from=held if in_place else None,
            path=path if in_place else None,
        )
