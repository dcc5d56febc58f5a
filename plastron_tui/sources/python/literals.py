"""Python literals: written as `ruff format` leaves them, and read."""

from __future__ import annotations

import ast
import keyword
import re

# Most literals are such strings, whose value is what stands in them.
_PLAIN = re.compile(r"""'[^'\\\n\r\0]*'|"[^"\\\n\r\0]*\"""")

_ESCAPES = {"\\": "\\\\", "\n": "\\n", "\r": "\\r", "\t": "\\t"}


def string(value: str) -> str:
    """Write a string.

    What does not print (control and bidirectional characters, lone surrogates, line
    separators) is escaped, so that the source shows what the string holds. Double quotes,
    unless single ones need fewer escapes.
    """
    quote = "'" if value.count('"') > value.count("'") else '"'
    return quote + "".join(_character(each, quote) for each in value) + quote


def number(value: int | float) -> str:
    """Write a finite number; a float keeps its point or exponent."""
    return repr(value).replace("e+", "e")


def octet(value: int) -> str:
    """Write one byte as `bytes` of length one; a negative one as its two's complement."""
    byte = value & 0xFF
    if chr(byte) == '"':
        return "b'\"'"
    text = _character(chr(byte), '"') if byte < 0x80 else f"\\x{byte:02x}"
    return f'b"{text}"'


def value_of(literal: str) -> object:
    """Return the value of a string, a number, or another constant.

    As `ast.literal_eval` does, which leaves functions behind that refer to each other: only the
    cycle collector frees them.

    Raises:
        ValueError: it is no literal.
        SyntaxError, MemoryError, RecursionError: Python cannot parse it.
    """
    if literal.isascii() and _PLAIN.fullmatch(literal):
        return literal[1:-1]
    body = ast.parse(literal.lstrip(" \t"), mode="eval").body
    if not isinstance(body, ast.Constant):
        raise ValueError(literal)
    return body.value


def is_name(text: str) -> bool:
    """Tell whether the text can be a name in Python source, and nothing else."""
    return text.isascii() and text.isidentifier() and not keyword.iskeyword(text)


def _character(character: str, quote: str) -> str:
    if character in _ESCAPES:
        return _ESCAPES[character]
    if character == quote:
        return "\\" + quote
    if character.isprintable():
        return character
    code = ord(character)
    if code < 0x100:
        return f"\\x{code:02x}"
    return f"\\u{code:04x}" if code < 0x10000 else f"\\U{code:08x}"
