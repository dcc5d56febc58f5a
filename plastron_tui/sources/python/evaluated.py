"""Values that were worked out of a file, and what comes of them."""

from __future__ import annotations

import operator
from collections.abc import Callable
from typing import NamedTuple

from plastron_tui.model.endpoint_details import Value

# What people write as a default is shorter; `'a' * 10 ** 9` is larger than the memory.
LONGEST = 1000
_LARGEST = 1e300

_TYPES: dict[type, str] = {bool: "bool", int: "int", float: "float", str: "string"}
_MADE = {"float": "float", "int": "int", "str": "string", "bool": "bool"}
CONVERSIONS = frozenset({*_MADE, "list", "tuple"})
"""The functions of Python that make a value of another."""

OPERATORS: dict[str, Callable[[float, float], float]] = {
    "+": operator.add,
    "-": operator.sub,
    "*": operator.mul,
    "/": operator.truediv,
    "//": operator.floordiv,
    "%": operator.mod,
    "**": operator.pow,
}
"""What is worked out of two numbers, by the sign."""


class Evaluated(NamedTuple):
    """What an expression gives.

    Attributes:
        type: the type of parameter that can hold it, None where that is not known.
        value: the value, None where that is not known.
        is_guess: whether the run may give another value of that type: it is the default of a
            parameter, or of an argument that another file may give.
    """

    type: str | None = None
    value: Value | None = None
    is_guess: bool = False

    @property
    def number(self) -> float | None:
        """The value of a number."""
        is_number = self.type in ("int", "float")
        return float(self.value) if is_number and isinstance(self.value, int | float) else None


UNKNOWN = Evaluated()


def evaluated(value: object) -> Evaluated:
    """Return a constant; one that no parameter can hold is unknown."""
    if not isinstance(value, bool | int | float | str):
        return UNKNOWN
    is_number = isinstance(value, int | float)
    is_usable = abs(value) < _LARGEST if isinstance(value, int | float) else len(value) <= LONGEST
    type_ = _TYPES[type(value)]
    return Evaluated(type_, value if is_usable else None) if is_number or is_usable else UNKNOWN


def computed(
    function: Callable[..., float], values: tuple[Value | None, ...], plain: Evaluated
) -> Evaluated:
    """Return what a function gives for numbers, or `plain` where one of them is not known."""
    numbers = [each for each in values if isinstance(each, int | float)]
    # The power of large numbers takes the more time the larger they are.
    if len(numbers) != len(values) or any(abs(each) > _LARGEST for each in numbers):
        return plain
    try:
        result = function(*map(float, numbers) if plain.type == "float" else numbers)
    except (ArithmeticError, ValueError, TypeError):
        return plain
    return evaluated(result)._replace(is_guess=plain.is_guess)


def repeated(items: Evaluated, count: Evaluated) -> Evaluated:
    """Return what `[0.0] * 6` is."""
    is_guess = items.is_guess or count.is_guess
    values, times = items.value, count.value
    is_known = isinstance(values, tuple) and type(times) is int and len(values) * times <= LONGEST
    if isinstance(values, tuple) and isinstance(times, int) and is_known:
        return Evaluated(items.type, values * times, is_guess)
    return Evaluated(items.type, None, is_guess)


def converted(function: str, given: Evaluated) -> Evaluated:
    """Return what `float(…)` and its like give."""
    value, is_guess = given.value, given.is_guess
    if function in ("list", "tuple"):
        return given if given.type is None or given.type.endswith("_list") else UNKNOWN
    plain = Evaluated(_MADE[function], None, is_guess)
    if function == "str":
        return given if given.type == "string" else plain
    if function == "bool":
        return plain._replace(value=bool(value)) if value is not None else plain
    if not isinstance(value, int | float):
        return plain
    return plain._replace(value=float(value) if function == "float" else int(value))
