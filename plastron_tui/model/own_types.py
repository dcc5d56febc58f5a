"""Interface types of the program's own: those that it makes, and those that it changes."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import NamedTuple, TypeAlias

from plastron_tui.diagnostics import Diagnostic, Span
from plastron_tui.ros.interfaces import Interface, InterfaceKind, InterfaceName

InterfaceKey: TypeAlias = tuple[InterfaceKind, InterfaceName]
OwnInterfaces: TypeAlias = Mapping[InterfaceKey, Interface]

SECTIONS: Mapping[InterfaceKind, tuple[str, ...]] = {
    InterfaceKind.MESSAGE: ("",),
    InterfaceKind.SERVICE: ("request", "response"),
    InterfaceKind.ACTION: ("goal", "result", "feedback"),
}
"""What the parts of a definition are called in statements; a message has one, without a name."""


class DefinitionSource(NamedTuple):
    """The definition file that a type was loaded from, and what it held."""

    path: Path
    text: bytes


class Definition(NamedTuple):
    """A type in one generation of ROS: its definition file, and what that says."""

    text: bytes
    interface: Interface


@dataclass(slots=True)
class OwnType:
    """A type that the program makes, or loads to change it.

    Attributes:
        name: what it is called, without its package.
        package: the package that it says it is of, "" for the program's own.
        kind: whether it is of messages, services or actions.
        span: the statement that makes or loads it.
        definitions: what it is in each generation of ROS that can have it.
        wrong: why another generation cannot.
        source: the file of one that was loaded, None for one that the program makes.
    """

    name: str
    package: str
    kind: InterfaceKind
    span: Span
    definitions: dict[int, Definition] = field(default_factory=dict)
    wrong: dict[int, Diagnostic] = field(default_factory=dict)
    source: DefinitionSource | None = None

    @property
    def is_changed(self) -> bool:
        """Whether its file is to hold something else than it does."""
        texts = {each.text for each in self.definitions.values()}
        return self.source is None or texts != {self.source.text}

    def with_definitions(
        self, definitions: dict[int, Definition], wrong: dict[int, Diagnostic]
    ) -> OwnType:
        """Return the type with another meaning."""
        return replace(self, definitions=definitions, wrong=wrong)


def interfaces_of(
    types: Iterable[OwnType], version: int, package: str
) -> dict[InterfaceKey, Interface]:
    """Return what own types are in a generation of ROS; those that it cannot have are left out.

    Args:
        types: the types.
        version: the generation of ROS.
        package: the package of types that name none.
    """
    found: dict[InterfaceKey, Interface] = {}
    for each in types:
        definition = each.definitions.get(version)
        if definition is not None:
            name = InterfaceName(each.package or package, each.name)
            found[each.kind, name] = definition.interface
    return found
