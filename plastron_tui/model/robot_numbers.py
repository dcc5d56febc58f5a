"""The numbers that statements about robots have: finite ones, and where each stands."""

from __future__ import annotations

from collections.abc import Iterator
from math import inf, isfinite
from typing import Any, NamedTuple

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.language.inputs import COMMENTS
from plastron_tui.ros.robots.description import Vector

from .mistake import Mistake

FARTHEST = 1e6
"""No robot is so large, in metres; what is written beyond it is no length."""

SHORTEST = 1e-6
"""No part of a robot is smaller, in metres."""

LIGHTEST, HEAVIEST = 1e-6, 1e9
"""What a part weighs at least and at most, in kilograms."""


class Number(NamedTuple):
    """A number of a statement, and where it stands."""

    value: float
    span: Span


def as_float(number: float) -> float:
    """Return a number of any size; one beyond all that is measured is infinite."""
    try:
        return float(number)
    except OverflowError:
        return inf if number > 0 else -inf


def numbers(statement: Any, slot: str) -> Iterator[Number]:
    """Yield the numbers of a slot: one, or three; none where nothing is said."""
    written = getattr(statement, slot)
    syntax = statement.syntax.child_by_field_name(slot)
    if written is None or syntax is None:
        return
    if not isinstance(written, tuple):
        yield Number(as_float(written), statement.span_of(slot))
        return
    parts = (each for each in syntax.named_children if each.kind_id not in COMMENTS)
    for number, part in zip(written, parts, strict=False):
        span = Span(part.start_byte, part.end_byte).moved(statement.shift)
        yield Number(as_float(number), span)


def vector_of(statement: Any, slot: str) -> Vector | None:
    """Return three numbers, None where nothing is said.

    Raises:
        Mistake: some are larger than anything is.
    """
    found = list(numbers(statement, slot))
    if not found:
        return None
    wrong = [each.span for each in found if not (isfinite(each.value) and _is_near(each.value))]
    if wrong:
        message = f"a number here is between -{FARTHEST:,.0f} and {FARTHEST:,.0f}"
        raise Mistake(*(Diagnostic(codes.BAD_ROBOT_NUMBER, message, each) for each in wrong))
    x, y, z = (each.value for each in found)
    return x, y, z


def _is_near(value: float) -> bool:
    return abs(value) <= FARTHEST
