"""Numbers of robots that look like those of another unit."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
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

from .robot_numbers import Number, as_float, numbers


def link_slips(statement: st.HasLink) -> Iterator[Diagnostic]:
    """Yield a warning for each number of a link that looks like one of another unit."""
    if statement.shape != "mesh":
        yield from _long(_lengths(statement))
    yield from _long(numbers(statement, "position"))
    for each in numbers(statement, "weight"):
        if each.value > HEAVIEST:
            yield _slip(f"{each.value:,.12g} kg is more than an excavator weighs", [each], "g")
    yield from _turned(statement)


def joint_slips(statement: st.HasJoint) -> Iterator[Diagnostic]:
    """Yield a warning for each number of a joint likewise."""
    yield from _long(numbers(statement, "position"))
    yield from _turned(statement)


def limit_slips(statement: st.LimitsJoint) -> Iterator[Diagnostic]:
    """Yield a warning for each number of a joint's limits likewise."""
    ends = [*numbers(statement, "minimum"), *numbers(statement, "maximum")]
    if statement.unit == "m":
        yield from _long(ends)
        return
    values = [each.value for each in ends]
    if statement.unit == "rad" and any(map(is_too_far_a_limit, values)):
        most = max(values, key=abs)
        yield _other_unit(statement, f"{most:.12g} rad are several turns", "deg")
    elif statement.unit == "deg":
        yield from _in_radians(statement, values)


def _lengths(statement: st.HasLink) -> Iterator[Number]:
    for argument in statement.size or ():
        value = argument.value if isinstance(argument, NamedArgument) else argument
        if isinstance(value, Literal) and isinstance(value.value, (int, float)):
            syntax = value.syntax
            where = Span(syntax.start_byte, syntax.end_byte).moved(statement.shift)
            yield Number(as_float(value.value), where)


def _long(lengths: Iterable[Number]) -> Iterator[Diagnostic]:
    """Yield a warning for lengths that belong together if they look like millimetres."""
    found = list(lengths)
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
    values = [each.value for each in numbers(statement, "rotation")]
    if statement.unit == "rad" and any(map(is_too_much_turned, values)):
        most = max(values, key=abs)
        yield _other_unit(statement, f"{most:.12g} rad is more than a whole turn", "deg")
    elif statement.unit == "deg":
        yield from _in_radians(statement, values)


def _in_radians(statement: Any, values: list[float]) -> Iterator[Diagnostic]:
    there = [each for each in values if each]
    if there and all(map(looks_like_radians, there)):
        message = f"{there[0]:.12g} deg is next to nothing, and a part of a turn in rad"
        yield _other_unit(statement, message, "rad")


def _other_unit(statement: Any, message: str, unit: str) -> Diagnostic:
    where = statement.span_of("unit")
    help_ = f"write `{unit}`"
    return Diagnostic(codes.UNIT_SLIP, message, where, help=help_, fix=write(unit, where))
