"""C++ literals: written as the compiler takes them, and read.

Source: ISO C++20, [lex.literal].
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence

_ESCAPES = {"\\": "\\\\", '"': '\\"', "\n": "\\n", "\r": "\\r", "\t": "\\t"}

_TRIGRAPH = re.compile(r"(?<=\?)\?")

_ESCAPE = re.compile(
    r"\\(?:([0-7]{1,3})|x([0-9A-Fa-f]+)|u([0-9A-Fa-f]{4})|U([0-9A-Fa-f]{8})|(\r?\n)|(.))", re.S
)
_SIMPLE = {"n": "\n", "t": "\t", "r": "\r", "0": "\0", "a": "\a", "b": "\b", "f": "\f", "v": "\v"}
_STRING = re.compile(r'(?:u8|[uUL])?"((?:[^"\\]|\\.)*)"(?:s|sv)?', re.S)
_RAW = re.compile(r'(?:u8|[uUL])?R"([^()\\\s]{0,16})\((.*)\)\1"(?:s|sv)?', re.S)
_NUMBER = re.compile(
    r"(0[xX][0-9a-fA-F]+|0[bB][01]+|\d+(?:\.\d*)?(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?)"
    r"([uUlLfFzZ]*)"
)
_STRING_OR_NAME = re.compile(r'(?:u8)?"(?:[^"\\]|\\.)*"|[A-Za-z_]\w*', re.S)

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


def string_value(text: str) -> str | None:
    """Return the value of a string literal, None for what is none."""
    if found := _RAW.fullmatch(text):
        return found[2]
    found = _STRING.fullmatch(text)
    return None if found is None else _ESCAPE.sub(_unescaped, found[1])


def replaced(
    name: str, defines: Mapping[str, Sequence[str]], depth: int = 0
) -> bool | int | float | str | None:
    """Return the value of a macro: a number, or strings and macros one after the other."""
    texts = set(defines.get(name, ()))
    if len(texts) != 1 or depth > 4:
        return None
    text = texts.pop().strip()
    while text.startswith("(") and text.endswith(")"):
        text = text[1:-1].strip()
    if text in ("true", "false"):
        return text == "true"
    if (number := number_value(text)) is not None:
        return number
    if _STRING_OR_NAME.sub("", text).strip():
        return None
    parts = [each[0] for each in _STRING_OR_NAME.finditer(text)][:32]
    if len(parts) == 1 and parts[0][:1] not in ('"', "u"):
        return replaced(parts[0], defines, depth + 1)
    found = []
    for part in parts:
        value = string_value(part) if '"' in part else replaced(part, defines, depth + 1)
        if not isinstance(value, str):
            return None
        found.append(value)
    return "".join(found)


def _unescaped(found: re.Match[str]) -> str:
    octal, hexadecimal, short, long, newline, simple = found.groups()
    if newline:
        return ""
    if simple is not None:
        return _SIMPLE.get(simple, simple)
    number = int(octal, 8) if octal else int(hexadecimal or short or long, 16)
    return chr(number) if number < 0x110000 and not 0xD800 <= number < 0xE000 else "�"


def number_value(text: str) -> int | float | None:
    """Return the value of a number, None for what is none."""
    if text[:1] in ("-", "+"):
        inner = number_value(text[1:].lstrip())
        return -inner if inner is not None and text[0] == "-" else inner
    found = _NUMBER.fullmatch(text.replace("'", ""))
    if found is None or len(text) > 400:
        return None
    digits, suffix = found[1], found[2].lower()
    if digits[:2].lower() in ("0x", "0b"):
        return int(digits, 0)
    if "f" in suffix or any(letter in digits for letter in ".eE"):
        return float(digits)
    is_octal = len(digits) > 1 and digits[0] == "0" and all(each in "01234567" for each in digits)
    return int(digits, 8) if is_octal else int(digits)
