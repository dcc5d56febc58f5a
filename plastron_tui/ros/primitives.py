"""The primitive types of ROS: what they hold, in which range, and what they start from.

Sources: the ROS 1 wiki page "msg" (field types) and the ROS 2 documentation "Interfaces".
"""

from __future__ import annotations

import sys
from collections.abc import Mapping
from dataclasses import dataclass

from plastron_tui.diagnostics.suggest import nearest

from .interfaces import Scalar

FLOAT32_LIMIT = 3.4028235677973366e38
"""The smallest magnitude that no longer rounds to a finite float32."""

LARGEST_FLOAT = sys.float_info.max
"""The greatest finite float64."""


@dataclass(frozen=True, slots=True)
class Primitive:
    """A primitive type in one generation of ROS.

    Attributes:
        name: the name in a definition.
        kind: the Python type of its values in Plastron: `bool`, `int`, `float` or `str`.
        default: the value of a field that nobody set.
        low: the least integer, None where the type is not an integer.
        high: the greatest integer, None where the type is not an integer.
        parts: the names of the two whole numbers that a ROS 1 `time` or `duration` consists of.
    """

    name: str
    kind: type[bool] | type[int] | type[float] | type[str]
    default: Scalar
    low: int | None = None
    high: int | None = None
    parts: tuple[str, ...] = ()

    @property
    def range_text(self) -> str:
        """The range of an integer type in words, "" for any other type."""
        return "" if self.low is None else f"{self.low} to {self.high}"


def _integers() -> dict[str, Primitive]:
    table = {}
    for bits in (8, 16, 32, 64):
        half, whole = 1 << (bits - 1), 1 << bits
        table[f"int{bits}"] = Primitive(f"int{bits}", int, 0, -half, half - 1)
        table[f"uint{bits}"] = Primitive(f"uint{bits}", int, 0, 0, whole - 1)
    return table


_SHARED = {
    "bool": Primitive("bool", bool, False),
    **_integers(),
    "char": Primitive("char", int, 0, 0, 255),
    "float32": Primitive("float32", float, 0.0),
    "float64": Primitive("float64", float, 0.0),
    "string": Primitive("string", str, ""),
}

PRIMITIVES: Mapping[int, Mapping[str, Primitive]] = {
    # ROS 1: `byte` is an alias of int8 and `char` one of uint8, whatever their names suggest.
    1: {
        **_SHARED,
        "byte": Primitive("byte", int, 0, -128, 127),
        "time": Primitive("time", float, 0.0, parts=("secs", "nsecs")),
        "duration": Primitive("duration", float, 0.0, parts=("secs", "nsecs")),
    },
    # ROS 2: `byte` is an octet (rclpy holds it as one `bytes` element), `char` still a uint8.
    2: {
        **_SHARED,
        "byte": Primitive("byte", int, 0, 0, 255),
        "wstring": Primitive("wstring", str, ""),
    },
}
"""The primitives of each generation of ROS, by name."""

# Seconds that fit the 32 bits of a ROS 1 time (unsigned) and duration (signed).
_SECONDS = {"time": (0, (1 << 32) - 1), "duration": (-(1 << 31), (1 << 31) - 1)}


_ELSEWHERE = {
    **dict.fromkeys(("int", "integer"), "int32"),
    **dict.fromkeys(("uint", "unsigned"), "uint32"),
    "short": "int16",
    "long": "int64",
    **dict.fromkeys(("float", "double", "real"), "float64"),
    **dict.fromkeys(("str", "text"), "string"),
    "boolean": "bool",
    "octet": "uint8",
    **{f"{sign}int{bits}_t": f"{sign}int{bits}" for sign in ("", "u") for bits in (8, 16, 32, 64)},
}
"""What other languages call primitive types, and which one takes what those mostly hold."""


def meant_primitive(word: str, ros_version: int) -> str | None:
    """Return the primitive that a word, which names none, was to be; None where none is near.

    A word of another language comes before a name that only looks alike: an `int` holds more than
    an `int8` does.
    """
    near = nearest(word, PRIMITIVES[ros_version]) if word.islower() else None
    return other_word(word) or near


def other_word(word: str) -> str | None:
    """Return the primitive that another language calls so, None where none does."""
    return _ELSEWHERE.get(word)


def primitive(name: str, ros_version: int) -> Primitive | None:
    """Return a primitive by its name, None where that generation of ROS has none such."""
    return PRIMITIVES[ros_version].get(name)


def check_scalar(
    type_name: str, value: object, ros_version: int, string_bound: int | None = None
) -> str | None:
    """Tell why a value does not fit a primitive field, None when it fits.

    A whole number fits a float field; a bool is no number, and a number no bool. A string must
    be encodable as UTF-8, and holds no NUL in ROS 2, whose strings end at the first one.

    Args:
        type_name: the primitive's name, without array brackets and string bound.
        value: the Python value as the program means it.
        ros_version: 1 or 2.
        string_bound: the most characters of a bounded string.

    Raises:
        KeyError: the name is no primitive of that generation of ROS.
    """
    wanted = PRIMITIVES[ros_version][type_name]
    if wanted.kind is bool:
        return None if isinstance(value, bool) else f"{_shown(value)} is not a `bool`"
    if wanted.kind is str:
        return _check_string(type_name, value, ros_version, string_bound)
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return f"{_shown(value)} is not a number, which `{type_name}` takes"
    if wanted.kind is int:
        return _check_integer(wanted, value)
    return _check_float(type_name, value)


def _check_integer(wanted: Primitive, value: int | float) -> str | None:
    if isinstance(value, float):
        return f"{_shown(value)} is not a whole number, which `{wanted.name}` takes"
    assert wanted.low is not None and wanted.high is not None
    if wanted.low <= value <= wanted.high:
        return None
    return f"{_shown(value)} does not fit `{wanted.name}` ({wanted.range_text})"


def _check_float(type_name: str, value: int | float) -> str | None:
    if type_name in _SECONDS:
        low, high = _SECONDS[type_name]
        if low <= value < high + 1:  # false for a nan
            return None
        return f"{_shown(value)} does not fit `{type_name}` ({low} to {high} seconds)"
    try:
        number = float(value)
    except OverflowError:
        return f"{_shown(value)} does not fit `{type_name}`"
    # An infinity, as a nan, is a value of its own; what becomes one by rounding is a mistake.
    is_finite = abs(number) < float("inf")
    if type_name == "float32" and is_finite and abs(number) >= FLOAT32_LIMIT:
        return f"{_shown(value)} does not fit `float32` (up to 3.4e38)"
    return None


NO_TEXT = "half of a surrogate pair is no text, and ROS sends text as UTF-8"


def has_surrogate(text: str) -> bool:
    """Tell whether a text has half of a surrogate pair, which UTF-8 cannot say."""
    return any("\ud800" <= character <= "\udfff" for character in text)


def _check_string(
    type_name: str, value: object, ros_version: int, string_bound: int | None
) -> str | None:
    if not isinstance(value, str):
        return f"{_shown(value)} is not a string, which `{type_name}` takes"
    if string_bound is not None and len(value) > string_bound:
        return f"{len(value)} characters do not fit `{type_name}<={string_bound}`"
    if has_surrogate(value):
        return NO_TEXT
    if ros_version == 2 and "\0" in value:
        return "a ROS 2 string ends at its first NUL character"
    return None


def _shown(value: object, width: int = 40) -> str:
    """Return a value as a program would write it, cut when it is long."""
    if isinstance(value, int) and not isinstance(value, bool) and abs(value) >= 10**width:
        return "a number of more than 40 digits"  # str() of a huge one is slow, or refused
    if isinstance(value, (list, tuple)):
        return "a list"
    if isinstance(value, str):
        return f'"{value}"' if len(value) <= width else f'"{value[: width - 1]}…"'
    text = str(value)
    return text if len(text) <= width else f"{text[: width - 1]}…"
