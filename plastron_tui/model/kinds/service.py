"""Services: what a node answers when others call."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Diagnostic, Label, Span, codes
from plastron_tui.language.statements import ProvidesService
from plastron_tui.ros.interfaces import Interface, InterfaceKind, InterfaceName

from .computed import check_computed

if TYPE_CHECKING:
    from ..run import Run
    from ..values import MessageValue
    from ..workspace import Node


class Service(NamedTuple):
    """A service that a node provides.

    Attributes:
        name: the service.
        type: its type, None where a file does not say it.
        callback: the function that answers, None where the target names one.
        span: the statement that made it.
        answer: the values of each answer, None where the program says none.
    """

    name: str
    type: InterfaceName | None
    callback: str | None = None
    span: Span | None = None
    answer: MessageValue | None = None


def provide(run: Run, statement: ProvidesService) -> None:
    """Let a node provide a service."""
    node = run.checks.node(statement)
    name, type_ = run.interface(statement, node, "service", InterfaceKind.SERVICE)
    run.checks.absent(statement, node)
    run.checks.function(statement, node, type_.name)
    answer = answer_of(run, statement, node, type_)
    service = Service(name, type_.name, statement.function, statement.span, answer)
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


def answer_of(
    run: Run, statement: ProvidesService, node: Node, type_: Interface
) -> MessageValue | None:
    """Return the answer that a statement gives, None where it gives none."""
    if statement.answer is None:
        return None
    answer = run.types.fit(statement, type_, run.checks.version_of(node), "answer")
    check_computed(run, statement, "answer", node, answer, heard=type_.fields)
    return answer
