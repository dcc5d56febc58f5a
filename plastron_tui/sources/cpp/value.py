"""Values that are known of expressions."""

from __future__ import annotations

from typing import NamedTuple


class Value(NamedTuple):
    """What an expression is worth.

    Attributes:
        value: the value; a list is a tuple.
        is_default: whether it is only where nobody sets a parameter of ROS otherwise.
        is_guess: whether it is the default of what a caller elsewhere may give otherwise.
    """

    value: bool | int | float | str | tuple[bool | int | float | str, ...]
    is_default: bool = False
    is_guess: bool = False

    def like(self, *others: Value) -> Value:
        """Return the value as unsure as others that it was made of."""
        return self._replace(
            is_default=self.is_default or any(each.is_default for each in others),
            is_guess=self.is_guess or any(each.is_guess for each in others),
        )

    @property
    def text(self) -> str | None:
        """The value where it is a string."""
        return self.value if isinstance(self.value, str) else None

    @property
    def number(self) -> int | float | None:
        """The value where it is a number."""
        is_number = isinstance(self.value, int | float) and not isinstance(self.value, bool)
        return self.value if is_number and isinstance(self.value, int | float) else None


def calculated(operator: str, one: int | float, other: int | float) -> int | float | None:
    """Return what an operator of C++ makes of two numbers, None where that is nothing."""
    try:
        match operator:
            case "+":
                return one + other
            case "-":
                return one - other
            case "*":
                return one * other
            case "/" if isinstance(one, int) and isinstance(other, int):
                quotient = abs(one) // abs(other)
                return quotient if (one < 0) == (other < 0) else -quotient
            case "/":
                return one / other
            case _:
                return None
    except (ZeroDivisionError, OverflowError):
        return None
