"""Timers: functions that a node calls again and again."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Span
from plastron_tui.language.statements import Repeats

from .rate import Rate, rate_of

if TYPE_CHECKING:
    from ..run import Run


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
    run.checks.absent(statement, node)
    run.checks.function(statement, node)
    rate = rate_of(run, statement, node)
    run.add(statement, node, Timer(statement.function, None, rate, statement.span))
