"""Which numbers fields and parameters can hold, and what is calculated of them."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from operator import mul, truediv
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.ros.interfaces import FieldType
from plastron_tui.ros.parameters import INTEGERS, ParameterType
from plastron_tui.ros.primitives import FLOAT32_LIMIT, LARGEST_FLOAT, primitive

from ..values import Computed, Number, calculated
from .needs import computed_of, rates_of
from .parameter import Parameter
from .rate import HIGHEST_RATE

if TYPE_CHECKING:
    from ..workspace import Node

_LOWEST_RATE = 0.001
"""The lowest rate that a node lets a parameter be set to that has no range, in hertz."""

_LARGEST_FLOAT32 = math.nextafter(FLOAT32_LIMIT, 0)


class Interval(NamedTuple):
    """All numbers from the least to the greatest."""

    least: Number
    most: Number

    def contains(self, other: Interval) -> bool:
        """Tell whether all numbers of another interval are in this one."""
        return self.least <= other.least and other.most <= self.most

    @property
    def holds_zero(self) -> bool:
        """Whether 0 is among them."""
        return self.least <= 0 <= self.most

    def common(self, other: Interval) -> Interval:
        """Return the numbers that are in both."""
        return Interval(max(self.least, other.least), min(self.most, other.most))


EVERY_FLOAT = Interval(-LARGEST_FLOAT, LARGEST_FLOAT)
EVERY_INTEGER = Interval(INTEGERS[0], INTEGERS[-1])


def field_range(type_: FieldType, ros_version: int) -> Interval | None:
    """Return the finite numbers that a field can hold, or its elements; None for no number."""
    known = primitive(type_.name, ros_version) if type_.package is None else None
    if known is None or known.parts:
        return None
    if known.low is not None and known.high is not None:
        return Interval(known.low, known.high)
    if known.kind is not float:
        return None
    is_short = type_.name == "float32"
    return Interval(-_LARGEST_FLOAT32, _LARGEST_FLOAT32) if is_short else EVERY_FLOAT


EVERY_NUMBER = Interval(-math.inf, math.inf)


def range_of_calculated(range_: Interval, steps: Sequence[tuple[str, Interval]]) -> Interval:
    """Return the numbers among which all is that is calculated of the numbers of intervals.

    Its ends are whole numbers where what is calculated is one for sure.
    """
    return ranges_of_terms(range_, steps)[-1]


def ranges_of_terms(range_: Interval, steps: Sequence[tuple[str, Interval]]) -> list[Interval]:
    """Return the range of all that is calculated on the way; the last is that of the whole."""
    total, term = Interval(0, 0), range_
    found = [term]
    for operator, other in steps:
        match operator:
            case "*":
                term = _among(term, other, mul)
            case "/":
                term = EVERY_NUMBER if other.holds_zero else _among(term, other, truediv)
            case _:
                total = _sum(total, term)
                term = other if operator == "+" else Interval(-other.most, -other.least)
        found += [term, _sum(total, term)]
    return found


def _sum(one: Interval, other: Interval) -> Interval:
    return _between(lambda: (one.least + other.least, one.most + other.most))


def _among(
    one: Interval, other: Interval, operation: Callable[[Number, Number], Number]
) -> Interval:
    """Return what an operation makes of two intervals: their ends make the ends of it."""
    return _between(lambda: [operation(first, second) for first in one for second in other])


def _between(ends: Callable[[], Sequence[Number]]) -> Interval:
    """Return all between the least and the greatest of some numbers; all where one is none."""
    try:
        found = ends()
    except OverflowError:
        return EVERY_NUMBER
    return EVERY_NUMBER if any(end != end for end in found) else Interval(min(found), max(found))


def limits_of(node: Node, parameter: Parameter, ros_version: int) -> Interval | None:
    """Return the numbers that a parameter may be set to, None where it may hold whatever it is of.

    They are those that the program allows. Where it allows all, a rate is positive. What goes
    into fields of integers has to fit each of them.
    """
    if parameter.holds is None or not parameter.holds.is_number:
        return None
    is_whole = parameter.holds is ParameterType.INT
    every = EVERY_INTEGER if is_whole else EVERY_FLOAT
    limits = every
    if parameter.minimum is not None and parameter.maximum is not None:
        limits = Interval(parameter.minimum, parameter.maximum)
    elif parameter.name in rates_of(node):
        limits = _rates(parameter, is_whole=is_whole)
    if is_whole:
        for each in computed_of(node, parameter.name):
            limits = limits.common(_fitting(each, ros_version))
    return None if limits == every else limits


def _rates(parameter: Parameter, *, is_whole: bool) -> Interval:
    default = parameter.default
    assert isinstance(default, (int, float))  # a rate is a number
    if is_whole:
        return Interval(1, int(HIGHEST_RATE))
    return Interval(min(_LOWEST_RATE, default), HIGHEST_RATE)


def _fitting(value: Computed, ros_version: int) -> Interval:
    """Return the integers of which a value is calculated that fits its field."""
    field, steps = field_range(value.type, ros_version), value.numbers
    if field is None or steps is None or value.is_float or not isinstance(field.least, int):
        return EVERY_INTEGER
    at_zero = calculated(0, steps)
    slope = calculated(1, steps) - at_zero
    if not isinstance(at_zero, int) or not isinstance(slope, int) or slope == 0:
        return EVERY_INTEGER
    ends = (field.least - at_zero, field.most - at_zero)
    low, high = ends if slope > 0 else (-ends[1], -ends[0])
    slope = abs(slope)
    return Interval(-(-low // slope), high // slope)
