"""Timers: functions that a node calls again and again."""

from __future__ import annotations

import math
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
    """Let a node call a function again and again, or one that its file calls at another rate."""
    node = run.checks.node(statement)
    check_not_repeated(run, statement, node)
    run.checks.function(statement, node)
    rate = rate_of(run, statement, node)
    if statement.function in node.of(Timer):
        # Where the file cannot be changed, it is this statement that asks for it.
        node.removed[statement.function] = statement.span
    run.add(statement, node, Timer(statement.function, None, rate, statement.span))


def check_not_repeated(run: Run, statement: Repeats, node: Node) -> None:
    """Check that a node does not repeat a function yet; the rate of a file may be changed."""
    timer = node.of(Timer).get(statement.function)
    if timer is None or timer.span is not None:
        run.checks.absent(statement, node)
    elif _is_same(timer.rate, rate_of(run, statement, node)):
        code, what = codes.ALREADY_REPEATING, f"`{node.variable}` repeats"
        raise run.checks.exists_already(statement, "function", node, code, what, None)


def _is_same(one: Rate | None, other: Rate | None) -> bool:
    if one is None or other is None:
        return False
    return one.parameter == other.parameter and math.isclose(one.hertz, other.hertz)
