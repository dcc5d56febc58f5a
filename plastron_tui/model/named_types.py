"""The interface types that a program names, and values that fit them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from plastron_tui.diagnostics import Diagnostic, Fix, write
from plastron_tui.language.declaration import Statement
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import Interface, InterfaceKind

from .context import Setting
from .libraries import default_library
from .mistake import Mistake
from .types import TypeProblem, TypeResolver
from .value_check import Fitter
from .values import MessageValue
from .workspace import Workspace


class NamedTypes:
    """Looks up the types that statements name, and fits values to them."""

    def __init__(
        self, setting: Setting, workspace: Workspace, fitters: Mapping[int, Fitter]
    ) -> None:
        """Start with nothing.

        Args:
            setting: what programs are interpreted in.
            workspace: what the program has built so far.
            fitters: those of an earlier interpretation, by their generation of ROS.
        """
        self._setting = setting
        self._workspace = workspace
        self._version = setting.ros_version(None)
        self._resolvers: dict[int, TypeResolver] = {}
        self.fitters: dict[int, Fitter] = {}
        self._earlier_fitters = fitters

    def named(
        self, statement: Statement, text: str, kind: InterfaceKind, version: int
    ) -> Interface:
        """Return the type that a statement names, in a generation of ROS."""
        found = self._resolver(version).resolve(text, kind)
        if not isinstance(found, TypeProblem):
            return found
        used = self._used_by_file(statement, text, kind)
        if used is not None:
            return used
        where = statement.span_of("type")
        remedy: str | None = self._elsewhere(text, kind, version)
        fix: Fix | None = None
        if remedy is None:
            remedy = found.help
            fix = None if found.right is None else write(found.right, where)
        raise Mistake(Diagnostic(found.code, found.message, where, help=remedy, fix=fix))

    def _used_by_file(
        self, statement: Statement, text: str, kind: InterfaceKind
    ) -> Interface | None:
        """Return the type that a loaded file uses under a name; only values need a definition."""
        node = self._workspace.nodes.get(getattr(statement, "node", ""))
        if node is None or node.source is None or getattr(statement, "input", None):
            return None
        found = {
            each.type
            for each in node.source.endpoints
            if each.type is not None
            and each.kind.facts.interface is kind
            and text
            in (
                each.type.name,
                str(each.type),
                f"{each.type.package}/{kind.value}/{each.type.name}",
            )
        }
        return Interface.undefined(found.pop(), kind) if len(found) == 1 else None

    def _elsewhere(self, text: str, kind: InterfaceKind, version: int) -> str | None:
        """Say how to get the other ROS, which has a type, where nobody chose this one."""
        if self._setting.is_chosen or version != self._version:
            return None
        other = 3 - version
        library = default_library(self._setting.libraries, other)
        if isinstance(self._resolver(other).resolve(text, kind), TypeProblem):
            return None
        return (
            f"ROS {other} has it, and ROS {version} is only the default: use `--target {library}`, "
            f"or write `target: {library}` in plastron.yaml"
        )

    def _resolver(self, version: int) -> TypeResolver:
        resolver = self._resolvers.get(version)
        if resolver is None:
            catalog = self._setting.catalog(version)
            resolver = self._resolvers[version] = TypeResolver(catalog)
            self.fitters[version] = Fitter(catalog, self._earlier_fitters.get(version))
        return resolver

    def catalog(self, version: int) -> Catalog:
        """Return the interface types of a generation of ROS."""
        return self._resolver(version).catalog

    def fit(
        self, statement: Any, type_: Interface, version: int, slot: str = "input"
    ) -> MessageValue:
        """Return the values in a slot of a statement as a message of a type.

        An answer's are those of the response, or of the result; others those of the message, the
        request or the goal.
        """
        fields = type_.response.fields if slot == "answer" else type_.fields
        value = self.fitters[version].fit(type_, fields, statement, slot)
        if isinstance(value, tuple):
            raise Mistake(*value)
        return value
