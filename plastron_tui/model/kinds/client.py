"""Clients: services that a node calls."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Span
from plastron_tui.language.statements import ClientRequests
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName

if TYPE_CHECKING:
    from ..run import Run
    from ..values import MessageValue


class Client(NamedTuple):
    """A service that a node calls, with the request of each call, in order."""

    name: str
    type: InterfaceName | None
    requests: tuple[MessageValue, ...] = ()
    span: Span | None = None


def request(run: Run, statement: ClientRequests) -> None:
    """Let a node call a service once more."""
    checks = run.checks
    node = checks.node(statement)
    version = checks.version_of(node)
    name = statement.service
    checks.name(statement, "service", name, version)
    type_ = run.types.named(statement, statement.type, InterfaceKind.SERVICE, version)
    value = run.types.fit(statement, type_, version)
    client = node.of(Client).get(name) or Client(name, type_.name, (), statement.span)
    run.add(statement, node, client._replace(requests=(*client.requests, value)))
