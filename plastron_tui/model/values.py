"""The values of a message, checked against its type, with nothing of their syntax left."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TypeAlias

from plastron_tui.ros.interfaces import FieldType, InterfaceName

Number: TypeAlias = int | float


@dataclass(frozen=True, slots=True)
class MessageValue:
    """The fields of a message that were given a value, by name, in the order of the type.

    What is not there keeps its default. A scalar is a Python `bool`, `int`, `float` or `str`
    that fits its field (a float field always has a `float`); an array is a tuple; a `time` or
    `duration` of ROS 1 is a tuple of its seconds and nanoseconds.
    """

    type: InterfaceName
    fields: dict[str, Value]


@dataclass(frozen=True, slots=True)
class OfParameter:
    """The value that a parameter of the node has when the message is sent."""

    name: str

    def __str__(self) -> str:
        return f"parameter '{self.name}'"


@dataclass(frozen=True, slots=True)
class OfReceived:
    """What a field of the received message holds, or the element at a position of a list."""

    path: tuple[str, ...]
    position: int | None = None

    def __str__(self) -> str:
        at = "" if self.position is None else f"[{self.position}]"
        return f"received.{'.'.join(self.path)}{at}"


Origin: TypeAlias = OfParameter | OfReceived
"""Where a value comes from that is known when it is sent."""

Operand: TypeAlias = Number | Origin
"""What a value is calculated with."""


@dataclass(frozen=True, slots=True)
class Computed:
    """A value that is known when it is sent.

    Attributes:
        source: where it comes from.
        steps: what is done to it in turn, as an operator and an operand each, with the precedence
            of arithmetic.
        type: the type of the field that it is for.
        is_float: whether a division, or a fraction among the numbers, makes it a float for sure.
    """

    source: Origin
    steps: tuple[tuple[str, Operand], ...]
    type: FieldType
    is_float: bool = False

    def __str__(self) -> str:
        steps = "".join(f" {operator} {operand}" for operator, operand in self.steps)
        return f"{self.source}{steps}"

    @property
    def origins(self) -> tuple[Origin, ...]:
        """All that it is calculated of, in the order in which it is written."""
        others = (operand for _, operand in self.steps)
        return (self.source, *(each for each in others if not isinstance(each, int | float)))

    @property
    def numbers(self) -> tuple[tuple[str, Number], ...] | None:
        """The steps where all of them are with numbers, None where one is not."""
        steps = tuple(
            (operator, operand)
            for operator, operand in self.steps
            if isinstance(operand, int | float)
        )
        return steps if len(steps) == len(self.steps) else None


def calculated(number: Number, steps: Sequence[tuple[str, Number]]) -> Number:
    """Return what is calculated of a number; infinite where it is too great for a float."""
    total, term = 0 * number, number
    try:
        for operator, other in steps:
            match operator:
                case "*":
                    term *= other
                case "/":
                    term /= other
                case _:
                    total += term
                    term = other if operator == "+" else -other
        return total + term
    except OverflowError:
        return math.inf


def computed_in(value: Value) -> Iterator[Computed]:
    """Yield what is computed in a value when it is sent."""
    return (each for _, each in computed_fields(value))


def computed_fields(value: Value, name: str = "") -> Iterator[tuple[str, Computed]]:
    """Yield what is computed in a value, each with the field that it is for: `linear.x`, `data[0]`.

    Args:
        value: the value.
        name: the field that it is for itself, nothing for a whole message.
    """
    match value:
        case Computed():
            yield name, value
        case MessageValue(fields=fields):
            for field, each in fields.items():
                yield from computed_fields(each, f"{name}.{field}" if name else field)
        case tuple():
            for index, each in enumerate(value):
                yield from computed_fields(each, f"{name}[{index}]")


def with_source(value: Value, old: OfParameter, new: OfParameter) -> Value:
    """Return a value in which what was computed from one parameter is so from another."""
    match value:
        case Computed(source=source, steps=steps):
            now = tuple((operator, new if each == old else each) for operator, each in steps)
            return replace(value, source=new if source == old else source, steps=now)
        case MessageValue(fields=fields):
            made = {name: with_source(each, old, new) for name, each in fields.items()}
            return replace(value, fields=made)
        case tuple():
            return tuple(with_source(each, old, new) for each in value)
        case _:
            return value


Value: TypeAlias = "bool | int | float | str | MessageValue | Computed | tuple[Value, ...]"
