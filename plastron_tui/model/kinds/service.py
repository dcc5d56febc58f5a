"""Services: what a node answers when others call."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Diagnostic, Label, Span, codes
from plastron_tui.language.statements import ProvidesService
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName
from plastron_tui.ros.names import spelled

from .subscription import Subscription

if TYPE_CHECKING:
    from ..run import Run
    from ..workspace import Node


class Service(NamedTuple):
    """A service that a node provides; without a `callback` the target names one."""

    name: str
    type: InterfaceName | None
    callback: str | None = None
    span: Span | None = None


def provide(run: Run, statement: ProvidesService) -> None:
    """Let a node provide a service."""
    node = run.checks.node(statement)
    name, type_ = run.interface(statement, node, "service", InterfaceKind.SERVICE)
    check_unprovided(run, statement, node)
    check_handler(run, statement, node, type_.name)
    service = Service(name, type_.name, statement.function, statement.span)
    run.add(statement, node, service)
    other = run.elsewhere(node, service)
    if other is not None:
        run.report(
            statement,
            Diagnostic(
                codes.SERVICE_PROVIDED_TWICE,
                f"another node of this program provides `{name}` too",
                statement.span_of("service"),
                help="a call reaches one of them only; give each a service of its own",
                labels=(Label(other.span, "provided here"),),
            ),
        )


def check_unprovided(run: Run, statement: ProvidesService, node: Node) -> None:
    """Check that a node does not provide a service yet."""
    if spelled(statement.service) in node.of(Service):
        what = f"`{node.variable}` provides"
        raise run.checks.exists_already(statement, "service", node, codes.ALREADY_PROVIDING, what)


def check_handler(
    run: Run, statement: ProvidesService, node: Node, type_: InterfaceName | None
) -> None:
    """Check that a function may take the requests of a type, None for one that is not known."""
    if statement.function is not None:
        run.checks.function(statement, node, node.of(Subscription).values())
        others = (each for each in node.of(Service).values() if type_ not in (None, each.type))
        run.checks.function(statement, node, others)
