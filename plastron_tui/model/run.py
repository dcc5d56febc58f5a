"""What the statements of a program work on while it is interpreted."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from plastron_tui.diagnostics import Diagnostic, Span, codes, write
from plastron_tui.language.declaration import Statement
from plastron_tui.language.lowering import Program
from plastron_tui.ros.interfaces import Interface, InterfaceKind
from plastron_tui.ros.names import check_parameter_name, spelled

from .checks import Checks, NameCheck
from .consequences import Consequences
from .context import Setting
from .kinds import Endpoint, EndpointKind, kind_of
from .messages import Messages
from .mistake import Mistake
from .named_types import NamedTypes
from .type_agreement import Agreements
from .value_check import Fitter
from .workspace import Node, Workspace


class Run:
    """A workspace in the making, and what knows about its parts.

    Attributes:
        setting: what the program is interpreted in.
        workspace: what it has built so far.
        consequences: what merely follows from an earlier mistake.
        checks: variables, names, functions.
        types: the interface types that statements name, and values of them.
        messages: the messages, for nodes of each ROS.
        agreements: who uses which type for a topic or a service.
        node_names: the names of the nodes that were created, and where.
        found: what is wrong, each with the offset of its statement.
    """

    def __init__(self, setting: Setting, fitters: Mapping[int, Fitter]) -> None:
        """Start with an empty workspace.

        Args:
            setting: what programs are interpreted in.
            fitters: those of an earlier interpretation, by their generation of ROS.
        """
        self.setting = setting
        self.workspace = Workspace()
        self.consequences = Consequences()
        self.checks = Checks(setting, self.workspace, self.consequences)
        self.types = NamedTypes(setting, self.workspace, self.consequences, fitters)
        self.messages = Messages(
            setting, self.workspace, self.checks, self.types, self.consequences
        )
        self.agreements = Agreements()
        self.node_names: dict[str, Span] = {}
        self.found: list[tuple[int, Diagnostic]] = []

    def begin(self, program: Program) -> None:
        """Go on with another program in the same workspace."""
        self.consequences.begin(program.broken)
        self.messages.begin(program)
        self.types.begin(program)
        self.found = []

    def report(self, statement: Statement, diagnostic: Diagnostic) -> None:
        """Note what is wrong with a statement, or beside it."""
        self.found.append((statement.span.start, diagnostic))

    def interface(
        self, statement: Any, node: Node, slot: str, kind: InterfaceKind
    ) -> tuple[str, Interface]:
        """Return the name and the type that a statement gives an endpoint of a node.

        Args:
            statement: the statement; its slot `type` names the type.
            node: the node.
            slot: the slot that has the name.
            kind: the kind of interface that the type is of.
        """
        version = self.checks.version_of(node)
        name = self.name(statement, slot, version)
        return name, self.types.named(statement, statement.type, kind, version)

    def name(
        self, statement: Statement, slot: str, version: int, check: NameCheck | None = None
    ) -> str:
        """Return the name that a slot has, as a generation of ROS takes it, and as it is spelled.

        Args:
            statement: the statement.
            slot: the slot that has the name.
            version: the generation of ROS.
            check: says what is wrong with a name, by default what the slot is called after.
        """
        written: str = getattr(statement, slot)
        self.checks.name(statement, slot, written, version, check)
        name = spelled(written)
        # ROS 2 knows no other parameters than private ones, and has no sign for them.
        if name != written and check is not check_parameter_name:
            where = statement.span_of(slot)
            self.report(
                statement,
                Diagnostic(
                    codes.PRIVATE_NAME,
                    "only ROS 1 takes a private name without a slash behind its `~`",
                    where,
                    help=f"write '{name}'",
                    fix=write(f"'{name}'", where),
                ),
            )
        return name

    def add(self, statement: Statement, node: Node, endpoint: Endpoint) -> None:
        """Give a node an endpoint, if its type agrees with that of all who use the name."""
        if kind_of(type(endpoint)).facts.interface is not None:
            version = self.checks.version_of(node)
            self._agree(endpoint, self.agreements.join(node, version, endpoint, statement))
        node.put(endpoint)

    def check_agreement(self, statement: Statement, node: Node, endpoint: Endpoint) -> None:
        """Check that the type of an endpoint agrees with that of all who use the name."""
        version = self.checks.version_of(node)
        self._agree(endpoint, self.agreements.conflict(node, version, endpoint, statement))

    def _agree(self, endpoint: Endpoint, conflict: Diagnostic | None) -> None:
        if conflict is not None:
            # Where the other use was to be taken away, it may be there because of a mistake.
            raise Mistake(*() if self.consequences.mentions(endpoint.name) else (conflict,))

    def take(self, statement: Statement, kind: EndpointKind) -> None:
        """Take an endpoint away from the node of a statement."""
        node = self.checks.node(statement)
        self.checks.unused(statement, node, kind)
        name = self.checks.take(statement, node, kind)
        self.agreements.leave(node, self.checks.version_of(node), kind, name)

    def elsewhere(self, node: Node, endpoint: Endpoint) -> Statement | None:
        """Return the statement by which another node has an endpoint of a kind and name."""
        version = self.checks.version_of(node)
        return self.agreements.other(node, version, endpoint, self.workspace.nodes)
