"""The YAML files of the catalog, each read once."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName

_DATA = Path(__file__).parent

Definitions = Mapping[str, Mapping[str, str]]
"""The definitions of a package: by kind (`msg`, `srv`, `action`), then by name."""


class Index(NamedTuple):
    """The names of a distribution's interfaces.

    Attributes:
        names: the interfaces of each kind, sorted.
        by_bare: of each kind, the full names by bare name.
        partial: the packages that the catalog holds only a few types of.
        packages: the packages that have interfaces of a kind, each with the kind.
    """

    names: Mapping[InterfaceKind, frozenset[InterfaceName]]
    by_bare: Mapping[InterfaceKind, Mapping[str, tuple[InterfaceName, ...]]]
    partial: frozenset[str]
    packages: frozenset[tuple[str, InterfaceKind]]


@cache
def index(distribution: str) -> Index:
    """Return the index of a distribution."""
    data = load(_DATA / distribution / "index.yaml")
    names: dict[InterfaceKind, frozenset[InterfaceName]] = {}
    by_bare: dict[InterfaceKind, dict[str, tuple[InterfaceName, ...]]] = {}
    for kind in InterfaceKind:
        table: dict[str, tuple[InterfaceName, ...]] = {}
        for package, listed in data[kind.value].items():
            for name in listed.split():
                table[name] = (*table.get(name, ()), InterfaceName(package, name))
        by_bare[kind] = table
        names[kind] = frozenset(name for found in table.values() for name in found)
    packages = frozenset((package, kind) for kind in InterfaceKind for package in data[kind.value])
    return Index(names, by_bare, frozenset((data["partial"] or "").split()), packages)


@cache
def definitions(distribution: str, package: str) -> Definitions:
    """Return the definitions of a package that the distribution's index lists."""
    data: Definitions = load(_DATA / distribution / f"{package}.yaml")
    return data


FURTHER = frozenset({"control_msgs", "example_interfaces", "nav2_msgs", "vision_msgs"})
"""Packages of ROS 2 that have types which only their full names mean."""


@cache
def further(distribution: str) -> Mapping[str, Definitions]:
    """Return the definitions that the index does not list, by package."""
    file = _DATA / "further" / f"{distribution}.yaml"
    data: Mapping[str, Definitions] = load(file) if file.is_file() else {}
    return data


@cache
def purposes() -> Mapping[str, Mapping[str, str]]:
    """Return what types are for, by kind (`msg`, …) and full name: a line, ` | `, and words.

    The types that people want most often come first.
    """
    data: Mapping[str, Mapping[str, str]] = load(_DATA / "purposes.yaml")
    return data


def load(file: Path) -> Any:
    """Read a YAML file of Plastron's own."""
    import yaml  # a program whose types are all known needs none of it

    # libyaml reads ten times as fast, and not every PyYAML was built with it.
    loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    with file.open("rb") as stream:
        return yaml.load(stream, Loader=loader)
