"""The numbers that statements about robots have: finite ones, and where each stands."""

from __future__ import annotations

from math import inf
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


def values(statement: Any, slot: str) -> tuple[float, ...]:
    """Return the numbers of a slot: one, or three; none where nothing is said."""
    written = getattr(statement, slot)
    if written is None:
        return ()
    return tuple(map(as_float, written if isinstance(written, tuple) else (written,)))


def numbers(statement: Any, slot: str) -> list[Number]:
    """Return the numbers of a slot, and where each stands."""
    found = values(statement, slot)
    syntax = statement.syntax.child_by_field_name(slot)
    if len(found) < 2 or syntax is None:
        return [Number(each, statement.span_of(slot)) for each in found]
    parts = (each for each in syntax.named_children if each.kind_id not in COMMENTS)
    spans = (Span(each.start_byte, each.end_byte).moved(statement.shift) for each in parts)
    return [Number(*each) for each in zip(found, spans, strict=True)]


def vector_of(statement: Any, slot: str) -> Vector | None:
    """Return three numbers, None where nothing is said.

    Raises:
        Mistake: some are larger than anything is.
    """
    found = values(statement, slot)
    if not found:
        return None
    if not all(map(is_near, found)):
        message = f"a number here is between -{FARTHEST:,.0f} and {FARTHEST:,.0f}"
        wrong = (each.span for each in numbers(statement, slot) if not is_near(each.value))
        raise Mistake(*(Diagnostic(codes.BAD_ROBOT_NUMBER, message, each) for each in wrong))
    x, y, z = found
    return x, y, z


def is_near(value: float) -> bool:
    """Tell whether a number of metres is one of a robot, and finite."""
    return abs(value) <= FARTHEST
