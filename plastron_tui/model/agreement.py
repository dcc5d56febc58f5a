"""Whether all nodes of a program mean the same type by one topic, or one service."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from plastron_tui.diagnostics import Code, Diagnostic, Label, write
from plastron_tui.language.declaration import Statement
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.ros.names import resolved_name

from .workspace import EndpointKind, Node

_User = tuple[str, EndpointKind]
_WITH_VALUES = (EndpointKind.PUBLISHER, EndpointKind.CLIENT)


@dataclass(slots=True)
class _Use:
    type: InterfaceName
    users: dict[_User, Statement] = field(default_factory=dict)


class Agreement:
    """The types of the topics (or of the services) that are in use, and who uses each."""

    def __init__(self, what: str, code: Code) -> None:
        """Start with nothing in use; a conflict of a `what` has the `code`."""
        self._what = what
        self._code = code
        self._uses: dict[str, _Use] = {}

    def join(
        self, node: Node, role: EndpointKind, name: str, type_: InterfaceName, statement: Statement
    ) -> Diagnostic | None:
        """Note that a node uses a name; return what is wrong if others use another type."""
        use = self._add(node, role, name, type_, statement)
        if use is None:
            return None
        elsewhere = next(iter(use.users.values())).span
        where = statement.span_of("type")
        # A message or a request with values is of one type only: they would not fit another.
        fix = None if role in _WITH_VALUES else write(str(use.type), where)
        return Diagnostic(
            self._code,
            f"{self._what} `{name}` is of type `{use.type}` elsewhere in this program",
            where,
            help=f"use `{use.type}` here too, or another {self._what}",
            fix=fix,
            labels=(Label(elsewhere, f"`{use.type}` here"),),
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

    def other(
        self, node: Node, role: EndpointKind, name: str, nodes: Mapping[str, Node]
    ) -> Statement | None:
        """Return the statement by which another node has the same role in a name, if one has."""
        use = self._uses.get(_key(node, name))
        if use is None:
            return None
        for (variable, other_role), where in use.users.items():
            # A node that was loaded again is not another one.
            if other_role is role and nodes[variable].name != node.name:
                return where
        return None

    def leave(self, node: Node, role: EndpointKind, name: str) -> None:
        """Note that a node uses a name no longer; a name that nobody uses is free again."""
        key = _key(node, name)
        use = self._uses.get(key)
        if use is None:
            return
        use.users.pop((node.variable, role), None)
        if not use.users:
            del self._uses[key]

    def _add(
        self, node: Node, role: EndpointKind, name: str, type_: InterfaceName, where: Statement
    ) -> _Use | None:
        """Add a user, or return the use that is of another type."""
        key = _key(node, name)
        use = self._uses.get(key)
        if use is None:
            self._uses[key] = _Use(type_, {(node.variable, role): where})
            return None
        if use.type != type_:
            return use
        use.users.setdefault((node.variable, role), where)
        return None


def _key(node: Node, name: str) -> str:
    return resolved_name(node.name, name)
