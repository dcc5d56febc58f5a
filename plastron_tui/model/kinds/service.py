"""Services: what a node answers when others call."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Diagnostic, Label, Span, codes
from plastron_tui.language.statements import ProvidesService
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName

from .subscription import Subscription

if TYPE_CHECKING:
    from ..run import Run


class Service(NamedTuple):
    """A service that a node provides; without a `callback` the target names one."""

    name: str
    type: InterfaceName | None
    callback: str | None = None
    span: Span | None = None


def provide(run: Run, statement: ProvidesService) -> None:
    """Let a node provide a service."""
    checks = run.checks
    node = checks.node(statement)
    name, type_ = run.interface(statement, node, "service", InterfaceKind.SERVICE)
    if name in node.of(Service):
        what = f"`{node.variable}` provides"
        raise checks.exists_already(statement, "service", node, codes.ALREADY_PROVIDING, what)
    if statement.function is not None:
        checks.function(statement, node, node.of(Subscription).values())
        others = (each for each in node.of(Service).values() if each.type != type_.name)
        checks.function(statement, node, others)
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
