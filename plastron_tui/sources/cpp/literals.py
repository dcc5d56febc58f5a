"""C++ literals: every value of a message or a parameter as the compiler takes it."""

from __future__ import annotations

import math
import re

_ESCAPES = {"\\": "\\\\", '"': '\\"', "\n": "\\n", "\r": "\\r", "\t": "\\t"}

_TRIGRAPH = re.compile(r"(?<=\?)\?")

_LARGEST_INT = 2**31 - 1
_LARGEST_LONG = 2**63 - 1


def string(value: str) -> str:
    """Write a string, as `std::string` takes it from a literal of its own.

    What does not print is written as the octal escapes of its UTF-8, which end after three digits;
    a trigraph is broken. A string with a zero in it says its length.
    """
    literal = quoted(value)
    if "\0" not in value:
        return literal
    return f"std::string({literal}, {len(value.encode(errors='surrogatepass'))})"


def quoted(value: str) -> str:
    """Write a string as a literal; a zero in it ends what C takes for the string."""
    # `??/` and its kin are other characters to C++14 and older.
    written = _TRIGRAPH.sub(r"\\?", "".join(map(_character, value)))
    return f'"{written}"'


def wide(value: str) -> str:
    """Write a string of 16-bit characters, as a `wstring` of ROS 2 takes it."""
    units = value.encode("utf-16-le", errors="surrogatepass")
    codes = [int.from_bytes(units[at : at + 2], "little") for at in range(0, len(units), 2)]
    if all(0x20 <= code < 0x7F and chr(code) not in '\\"?' for code in codes):
        return f'u"{value}"'
    listed = ", ".join(f"0x{code:04x}" for code in codes)
    return f"std::u16string({{{listed}}})"


def integer(value: int) -> str:
    """Write a whole number that fits 64 bits; the least of all has no literal of its own."""
    if value == -_LARGEST_LONG - 1:
        return f"(-{_LARGEST_LONG}LL - 1)"
    if value > _LARGEST_LONG:
        return f"{value}ULL"
    return f"{value}LL" if abs(value) > _LARGEST_INT else str(value)


def real(value: float) -> str:
    """Write a number with a point or an exponent, or what stands for none such."""
    if math.isnan(value):
        return "std::numeric_limits<double>::quiet_NaN()"
    if math.isinf(value):
        sign = "-" if value < 0 else ""
        return f"{sign}std::numeric_limits<double>::infinity()"
    return repr(value).replace("e+", "e")


def boolean(value: bool) -> str:
    """Write a truth value."""
    return "true" if value else "false"


def scalar(value: bool | int | float | str) -> str:
    """Write a value of a type that Python tells."""
    match value:
        case bool():
            return boolean(value)
        case int():
            return integer(value)
        case float():
            return real(value)
        case _:
            return string(value)


def _character(character: str) -> str:
    if character in _ESCAPES:
        return _ESCAPES[character]
    if character.isprintable():
        return character
    return "".join(f"\\{byte:03o}" for byte in character.encode(errors="surrogatepass"))
