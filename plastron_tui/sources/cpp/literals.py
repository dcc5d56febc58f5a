"""The literals of C++ as values. Source: ISO C++20, [lex.literal]."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

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
