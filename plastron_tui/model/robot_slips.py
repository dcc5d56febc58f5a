"""Numbers of robots that look like those of another unit."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from plastron_tui.diagnostics import Diagnostic, Edit, Fix, Span, codes, write
from plastron_tui.language import statements as st
from plastron_tui.language.inputs import Literal, NamedArgument
from plastron_tui.ros.robots.plausible import (
    HEAVIEST,
    LONGEST,
    is_too_far_a_limit,
    is_too_much_turned,
    looks_like_radians,
)

from .robot_numbers import Number, as_float, numbers, values


def link_slips(statement: st.HasLink) -> Iterator[Diagnostic]:
    """Yield a warning for each number of a link that looks like one of another unit."""
    if statement.shape != "mesh":
        yield from _long([*_lengths(statement)])
    yield from _far(statement)
    weight = statement.weight
    if weight is not None and weight > HEAVIEST:
        message = f"{weight:,.12g} kg is more than an excavator weighs"
        yield _slip(message, numbers(statement, "weight"), "g")
    yield from _turned(statement)


def joint_slips(statement: st.HasJoint) -> Iterator[Diagnostic]:
    """Yield a warning for each number of a joint likewise."""
    yield from _far(statement)
    yield from _turned(statement)


def limit_slips(statement: st.LimitsJoint) -> Iterator[Diagnostic]:
    """Yield a warning for each number of a joint's limits likewise."""
    slots = ("minimum", "maximum")
    ends = [value for slot in slots for value in values(statement, slot)]
    if statement.unit == "m":
        yield from _long([each for slot in slots for each in numbers(statement, slot)])
    elif statement.unit == "rad" and any(map(is_too_far_a_limit, ends)):
        most = max(ends, key=abs)
        yield _other_unit(statement, f"{most:.12g} rad is several turns", "deg")
    elif statement.unit == "deg":
        yield from _in_radians(statement, ends)


def _lengths(statement: st.HasLink) -> Iterator[Number]:
    for argument in statement.size or ():
        value = argument.value if isinstance(argument, NamedArgument) else argument
        if isinstance(value, Literal) and isinstance(value.value, (int, float)):
            syntax = value.syntax
            where = Span(syntax.start_byte, syntax.end_byte).moved(statement.shift)
            yield Number(as_float(value.value), where)


def _far(statement: st.HasLink | st.HasJoint) -> Iterator[Diagnostic]:
    if any(abs(each) > LONGEST for each in values(statement, "position")):
        yield from _long(numbers(statement, "position"))


def _long(found: Sequence[Number]) -> Iterator[Diagnostic]:
    """Yield a warning for lengths that belong together if they look like millimetres."""
    if any(abs(each.value) > LONGEST for each in found):
        longest = max((each.value for each in found), key=abs)
        yield _slip(f"{longest:,.12g} m is longer than robots are", found, "mm")


def _slip(message: str, numbers_: Sequence[Number], unit: str) -> Diagnostic:
    """Return the warning of numbers that may be in a thousandth of their unit."""
    where = Span(numbers_[0].span.start, numbers_[-1].span.end)
    right = [f"{each.value / 1000:.12g}" for each in numbers_]
    edits = tuple(
        Edit(each.span, text) for each, text in zip(numbers_, right, strict=True) if each.value
    )
    written = ", ".join(right)
    help_ = f"in {unit}? then write `{written}`"
    return Diagnostic(
        codes.UNIT_SLIP, message, where, help=help_, fix=Fix(f"write `{written}`", edits)
    )


def _turned(statement: st.HasLink | st.HasJoint) -> Iterator[Diagnostic]:
    angles = values(statement, "rotation")
    if statement.unit == "rad" and any(map(is_too_much_turned, angles)):
        most = max(angles, key=abs)
        yield _other_unit(statement, f"{most:.12g} rad is more than a whole turn", "deg")
    elif statement.unit == "deg":
        yield from _in_radians(statement, angles)


def _in_radians(statement: Any, angles: Sequence[float]) -> Iterator[Diagnostic]:
    there = [each for each in angles if each]
    if there and all(map(looks_like_radians, there)):
        message = f"{there[0]:.12g} deg is next to nothing, and a part of a turn in rad"
        yield _other_unit(statement, message, "rad")


def _other_unit(statement: Any, message: str, unit: str) -> Diagnostic:
    where = statement.span_of("unit")
    help_ = f"write `{unit}`"
    return Diagnostic(codes.UNIT_SLIP, message, where, help=help_, fix=write(unit, where))
