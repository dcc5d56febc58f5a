"""Calculations of several values that are received, with what the language means by them."""

from __future__ import annotations

import math
import operator
import random
import struct
from collections.abc import Iterator
from dataclasses import dataclass

from plastron_tui.model.kinds.ranges import field_range
from plastron_tui.model.values import Computed, OfReceived, Operand
from plastron_tui.ros.interfaces import Field, FieldType

INTEGERS = [f"{sign}int{bits}" for bits in (8, 16, 32, 64) for sign in ("", "u")]
FLOATS = ["float32", "float64"]
NUMBERS = [*INTEGERS, *FLOATS]
HEARD = tuple(
    field
    for name in NUMBERS
    for field in (
        Field(name, FieldType(name)),
        Field(f"{name}s", FieldType(name, is_array=True)),
    )
)
"""What is received: a number and a list of each type."""

TAKEN = ["int64", "uint64", "int16", "uint8", "float32", "float64"]
_ARITHMETIC = {
    "+": operator.add,
    "-": operator.sub,
    "*": operator.mul,
    "/": operator.truediv,
}

REFUSED = "!"
"""What a field gets that cannot hold what is calculated: nothing."""


@dataclass(frozen=True, slots=True)
class Calculation:
    """What is calculated of two or three numbers.

    Attributes:
        value: the calculation.
        received: the numbers, by the fields that hold them; those of lists are alone there.
        wanted: what the field gets, `REFUSED` for nothing.
    """

    value: Computed
    received: dict[str, int | float]
    wanted: str | int | float


def calculations(count: int, seed: int) -> Iterator[Calculation]:
    """Yield calculations: of the smallest and the greatest numbers first, then random ones."""
    for taken in TAKEN:
        for types in (("int64", "int64"), ("uint64", "int8"), ("float64", "int64")):
            for sign in _ARITHMETIC:
                for end in (0, -1):
                    yield _calculation(
                        types, (sign,), taken, tuple(_ends(name)[end] for name in types)
                    )
    chance = random.Random(seed)
    for _ in range(count):
        first, *others = chance.sample(NUMBERS, chance.choice((2, 3)))
        types = (chance.choice((first, others[0])), *others)
        signs = tuple(chance.choice("+-*/") for _ in others)
        numbers = tuple(chance.choice((*_ends(name), 0, 1, 2, 100)) for name in types)
        yield _calculation(types, signs, chance.choice(TAKEN), numbers)


def _ends(name: str) -> tuple[int | float, int | float]:
    if name in FLOATS:
        return -2.5, 1048576.125
    range_ = field_range(FieldType(name), 2)
    assert range_ is not None
    return range_.least, range_.most


def _calculation(
    types: tuple[str, ...], signs: tuple[str, ...], taken: str, given: tuple[int | float, ...]
) -> Calculation:
    numbers = [
        float(number) if name in FLOATS else number
        for name, number in zip(types, given, strict=True)
    ]
    names = [types[0], *(f"{name}s" for name in types[1:])]
    origins: list[Operand] = [OfReceived((name,), 0) for name in names[1:]]
    is_whole = "/" not in signs and not {*types} & {*FLOATS}
    # A field of integers takes no fraction.
    target = taken if is_whole or taken in FLOATS else "float64"
    value = Computed(
        OfReceived((types[0],)),
        tuple(zip(signs, origins, strict=True)),
        FieldType(target),
        "/" in signs,
    )
    return Calculation(
        value, dict(zip(names, numbers, strict=True)), _wanted(numbers, signs, target)
    )


def _wanted(numbers: list[int | float], signs: tuple[str, ...], taken: str) -> str | int | float:
    """Return what Python makes of a calculation, as a field of a type holds it."""
    shown = " ".join(
        part for pair in zip(("", *signs), map(repr, numbers), strict=True) for part in pair
    )
    try:
        found = eval(shown)
    except ZeroDivisionError:
        return REFUSED
    if taken in INTEGERS:
        range_ = field_range(FieldType(taken), 2)
        assert range_ is not None
        return found if range_.least <= found <= range_.most else REFUSED
    return stored(taken, found)


def stored(taken: str, number: int | float) -> float:
    """Return a number as a field of floats holds it."""
    if taken == "float64":
        return float(number)
    try:
        return float(struct.unpack("f", struct.pack("f", number))[0])
    except OverflowError:
        return math.copysign(math.inf, number)
