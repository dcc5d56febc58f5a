"""Clients: services that a node calls."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Span
from plastron_tui.language.statements import ClientRequests
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName

from .computed import check_computed
from .rate import Rate, rate_of

if TYPE_CHECKING:
    from ..run import Run
    from ..values import MessageValue


class Request(NamedTuple):
    """One request, and how often it is made, None for once."""

    value: MessageValue
    rate: Rate | None = None


class Client(NamedTuple):
    """A service that a node calls, with its requests, in order."""

    name: str
    type: InterfaceName | None
    requests: tuple[Request, ...] = ()
    span: Span | None = None


def request(run: Run, statement: ClientRequests) -> None:
    """Let a node call a service once more."""
    node = run.checks.node(statement)
    name, type_ = run.interface(statement, node, "service", InterfaceKind.SERVICE)
    value = run.types.fit(statement, type_, run.checks.version_of(node))
    client = node.of(Client).get(name)
    check_computed(run, statement, "input", node, value)
    made = Request(value, rate_of(run, statement, node))
    requests = (made,) if client is None else (*client.requests, made)
    span = statement.span if client is None else client.span
    run.add(statement, node, Client(name, type_.name, requests, span))
