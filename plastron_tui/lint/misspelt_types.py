"""Types of endpoints that their package does not have, one slip away from one that it has."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from functools import cache
from pathlib import Path

from plastron_tui.diagnostics import Span
from plastron_tui.diagnostics.suggest import nearest
from plastron_tui.ros.catalog import DISTRIBUTIONS, Catalog
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName
from plastron_tui.ros.name_slips import is_slip

from .tree import SourceTree, once_a_tree


@once_a_tree
def misspelt_types(tree: SourceTree) -> Mapping[tuple[Path, Span], tuple[InterfaceName, str]]:
    """Return the types that there are not, by call, each with the name that is meant.

    A definition with a mistake is there, and so is one that another release of ROS has.
    """
    lists = {
        (version, kind): _by_package(catalog, kind)
        for version, catalog in tree.catalogs.items()
        for kind in InterfaceKind
    }
    found: dict[tuple[Path, Span], tuple[InterfaceName, str]] = {}
    for unit in tree.built:
        for endpoint in (each for node in unit.nodes for each in node.endpoints):
            kind, type_ = endpoint.kind.facts.interface, endpoint.type
            if kind is None or type_ is None or endpoint.is_guess or unit.is_test:
                continue
            names = lists.get((unit.ros_version, kind), {}).get(type_.package, frozenset())
            if not names or type_.name in names:
                continue
            near = sorted(each for each in names if is_slip(type_.name, each))
            if not near or not _is_undefined(tree, unit.ros_version, kind, type_):
                continue
            meant = nearest(type_.name, near) or near[0]
            found[unit.path_of(endpoint), endpoint.span] = type_, meant
    return found


def _by_package(catalog: Catalog, kind: InterfaceKind) -> Mapping[str, frozenset[str]]:
    found: dict[str, set[str]] = defaultdict(set)
    for name in catalog.names(kind):
        found[name.package].add(name.name)
    return {package: frozenset(names) for package, names in found.items()}


def _is_undefined(
    tree: SourceTree, version: int, kind: InterfaceKind, type_: InterfaceName
) -> bool:
    """Tell whether a type is surely none: all types of its package are known, in all releases."""
    catalog = tree.catalogs[version]
    if type_.package in tree.packages:
        is_whole = _is_read_wholly(tree, type_)
    else:
        is_whole = catalog.has_all_of(type_.package, kind)
    if not is_whole or catalog.find(type_, kind) is not None:
        return False
    # In ROS 1 the parts of services and actions are types of their own.
    owners = (InterfaceKind.SERVICE, InterfaceKind.ACTION) if version == 1 else ()
    is_part = kind is InterfaceKind.MESSAGE and any(
        each.package == type_.package and type_.name.startswith(each.name)
        for owner in owners
        for each in catalog.names(owner)
    )
    return not is_part and all(each.find(type_, kind) is None for each in _releases())


@cache
def _releases() -> tuple[Catalog, ...]:
    return tuple(map(Catalog, DISTRIBUTIONS))


def _is_read_wholly(tree: SourceTree, type_: InterfaceName) -> bool:
    """Tell whether a package of the workspace has no other place for a type's definition."""
    build = tree.packages[type_.package].build
    if build is None or build.definitions or not tree.is_whole or type_.package in tree.namesakes:
        return False
    return all(each.partition(".")[0] != type_.name for each in build.files)
