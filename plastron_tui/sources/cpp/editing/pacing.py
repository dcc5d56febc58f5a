"""Letting a timer or a loop of a file tick at another rate."""

from __future__ import annotations

import math
import re

from tree_sitter import Node

from plastron_tui.sources.written_anew import written_anew

from .. import literals
from ..durations import seconds
from ..scopes import Scope
from .replacing import NotInPlaceError, Replacement

_LITERAL = re.compile(r"[\d.']+(?:ns|us|ms|s|min|h)")
_CHRONO = re.compile(
    r"(?P<head>(?:std::)?(?:chrono::)?)(?P<unit>nanoseconds|microseconds|milliseconds|seconds)"
    r"(?P<open>[({])\s*[\d.']+\s*(?P<close>[)}])"
)
_REAL = re.compile(
    r"(?P<head>(?:ros::(?:Wall|Steady)?Duration|rclcpp::Duration::from_seconds"
    r"|(?:std::)?chrono::duration<(?:double|float)>)\s*[({]\s*)(?P<one>1(?:\.0*)?\s*/\s*)?"
    r"(?P<number>[\d.']+f?|[A-Za-z_]\w*(?:(?:\.|->)\w+)*)(?P<tail>\s*[)}])"
)
_MOST_DIGITS = 9
"""How long a number of seconds may be that stands for itself: `0.3333333333333333` says less than
`1.0 / 3.0`."""
_UNITS = (("s", "seconds", 1), ("ms", "milliseconds", 10**3), ("us", "microseconds", 10**6),
          ("ns", "nanoseconds", 10**9))  # fmt: skip


def set_period(
    update: Replacement, node: Node, scope: Scope, hertz: float, *, is_again: bool = False
) -> None:
    """Write another period for a duration, as the file writes it.

    A number in it may be a variable's: that it no longer follows that is told. A timer that is
    created again at such a rate keeps it.

    Raises:
        NotInPlaceError: it is not written as a literal.
    """
    syntax = scope.file.syntax
    known = seconds(update.analysis, node, scope)
    number = None if known is None else known.number
    if number and math.isclose(1 / number, hertz):
        return
    if node.type in ("identifier", "field_identifier", "field_expression"):
        raise NotInPlaceError
    text = syntax.word(node).strip()
    found = _REAL.fullmatch(text)
    is_variable = found is not None and found["number"][0] not in ".0123456789"
    if is_variable and is_again:
        raise NotInPlaceError
    update.put(scope.file, node, _period(text, hertz))
    if found is not None and is_variable:
        message = f"the rate of `{update.old}` no longer follows `{found['number']}`"
        update.plan.notes.append(written_anew(message, update.change.endpoint, update.old))


def set_rate(update: Replacement, node: Node, scope: Scope, hertz: float) -> None:
    """Write another number of hertz in a literal.

    Raises:
        NotInPlaceError: it is none.
    """
    if node.type != "number_literal":
        raise NotInPlaceError
    update.put(scope.file, node, _number(hertz))


def _period(text: str, hertz: float) -> str:
    period = 1 / hertz
    if _LITERAL.fullmatch(text):
        for suffix, _, scale in _UNITS:
            if _is_whole(period * scale):
                return f"{round(period * scale)}{suffix}"
        return f"{round(period * 10**9)}ns"
    if found := _CHRONO.fullmatch(text):
        for _, unit, scale in _UNITS:
            if _is_whole(period * scale) or unit == "nanoseconds":
                count = round(period * scale)
                return f"{found['head']}{unit}{found['open']}{count}{found['close']}"
    if found := _REAL.fullmatch(text):
        text = literals.real(period)
        if len(text) > _MOST_DIGITS:
            text = f"1.0 / {literals.real(hertz)}"
        number = f"{found['one']}{literals.real(hertz)}" if found["one"] else text
        return f"{found['head']}{number}{found['tail']}"
    raise NotInPlaceError


def _is_whole(number: float) -> bool:
    return number >= 1 and math.isclose(number, round(number), rel_tol=1e-9)


def _number(value: float) -> str:
    return str(int(value)) if value == int(value) else literals.real(value)
