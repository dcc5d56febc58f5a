"""Whether all nodes of a program mean the same type by one topic, or one service."""

from __future__ import annotations

from dataclasses import dataclass, field

from plastron_tui.diagnostics import Diagnostic, Label
from plastron_tui.language.declaration import Statement
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.ros.names import resolved_name

from .source import EndpointKind
from .workspace import Node

_User = tuple[str, EndpointKind]


@dataclass(slots=True)
class _Use:
    type: InterfaceName
    where: Statement
    users: set[_User] = field(default_factory=set)


class Agreement:
    """The types of the topics (or of the services) that are in use, and who uses each."""

    def __init__(self, what: str) -> None:
        self._what = what
        self._uses: dict[str, _Use] = {}

    def join(
        self, node: Node, role: EndpointKind, name: str, type_: InterfaceName, statement: Statement
    ) -> Diagnostic | None:
        """Note that a node uses a name; return what is wrong if others use another type."""
        use = self._add(node, role, name, type_, statement)
        if use is None:
            return None
        return Diagnostic(
            f"{self._what}-type-conflict",
            f"{self._what} `{name}` is of type `{use.type}` elsewhere in this program",
            statement.span_of("type"),
            help=f"use `{use.type}` here too, or another {self._what}",
            labels=(Label(use.where.span, f"`{use.type}` here"),),
        )

    def adopt(
        self,
        node: Node,
        role: EndpointKind,
        name: str,
        type_: InterfaceName | None,
        statement: Statement,
    ) -> None:
        """Note what a file holds; what does not agree there is not for the program to mend."""
        if type_ is not None:
            self._add(node, role, name, type_, statement)

    def leave(self, node: Node, role: EndpointKind, name: str) -> None:
        """Note that a node uses a name no longer; a name that nobody uses is free again."""
        key = resolved_name(node.name, name)
        use = self._uses.get(key)
        if use is None:
            return
        use.users.discard((node.variable, role))
        if not use.users:
            del self._uses[key]

    def _add(
        self, node: Node, role: EndpointKind, name: str, type_: InterfaceName, where: Statement
    ) -> _Use | None:
        """Add a user, or return the use that is of another type."""
        key = resolved_name(node.name, name)
        use = self._uses.get(key)
        if use is None:
            self._uses[key] = _Use(type_, where, {(node.variable, role)})
            return None
        if use.type != type_:
            return use
        use.users.add((node.variable, role))
        return None
