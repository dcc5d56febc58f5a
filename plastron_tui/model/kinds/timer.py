"""Timers: functions that a node calls again and again."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Span, codes
from plastron_tui.language.statements import Repeats

from .rate import Rate, rate_of

if TYPE_CHECKING:
    from ..run import Run
    from ..workspace import Node


class Timer(NamedTuple):
    """A function that a node calls at a rate; `type` is None, a timer has none.

    `rate` is None where a file does not say it.
    """

    name: str
    type: None = None
    rate: Rate | None = None
    span: Span | None = None


def repeat(run: Run, statement: Repeats) -> None:
    """Let a node call a function again and again."""
    node = run.checks.node(statement)
    check_unrepeated(run, statement, node)
    check_repeated(run, statement, node)
    rate = rate_of(run, statement, node)
    run.add(statement, node, Timer(statement.function, None, rate, statement.span))


def check_unrepeated(run: Run, statement: Repeats, node: Node) -> None:
    """Check that a node does not repeat a function yet."""
    if statement.function in node.of(Timer):
        what = f"`{node.variable}` repeats"
        raise run.checks.exists_already(statement, "function", node, codes.ALREADY_REPEATING, what)


def check_repeated(run: Run, statement: Repeats, node: Node) -> None:
    """Check that a function may be called without anything that it is handed."""
    from . import EndpointKind  # which imports this file

    run.checks.function(statement, node, EndpointKind.TIMER)
