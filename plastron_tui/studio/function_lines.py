"""Where a text of Python or C++ defines a function, and where that gives something back."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

_NEAR = 200
"""So many bytes before a name are looked at: nobody declares a function further on in a line."""

_DEF = re.compile(rb"[ \t]*(?:async[ \t]+)?def[ \t]+")
_TYPE = re.compile(rb"[\w:<>,&* \t]*")
_WORD = re.compile(rb"[ \t]*(\w+)")
_RETURN = re.compile(rb"\s*return\b")
_LONGEST_FUNCTION = 400
"""Lines of a function that are looked at."""
_NO_TYPES = frozenset(
    {b"return", b"else", b"new", b"delete", b"throw", b"co_return", b"co_await", b"co_yield"}
)
_LETTERS = b"abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_"


def function_lines(text: bytes, function: str, *, is_python: bool) -> Iterator[int]:
    """Yield the lines, from 1, that define or declare a function.

    It takes time in proportion to the text, whatever that holds: a folder may hold anything, and
    an expression that goes back and forth over a long line would let no key through.

    Args:
        text: the file's text.
        function: the function's name; what is before a last `.` or `::` is left out.
        is_python: the text is Python; else it is C++.
    """
    name = re.escape(function.rpartition(".")[2].rpartition("::")[2].encode())
    after, is_head = (rb"\b", _is_python_head) if is_python else (rb"[ \t]*\(", _is_cpp_head)
    line, counted = 1, 0
    for match in re.finditer(rb"\b%b%b" % (name, after), text):
        near = max(0, match.start() - _NEAR)
        start = text.rfind(b"\n", near, match.start()) + 1
        if (start or not near) and is_head(text[start : match.start()]):
            line += text.count(b"\n", counted, start)
            counted = start
            yield line


def answer_line(text: bytes, line: int, *, is_python: bool) -> int | None:
    """Return the line of a function at which what it gives back is written, from 1.

    That is its first `return`; of one without, the last line of its body. None where a line only
    declares a function, or its body has no end in so many lines.

    Args:
        text: the file's text.
        line: the line that defines the function, from 1.
        is_python: the text is Python; else it is C++.
    """
    lines = text.split(b"\n")[line - 1 : line - 1 + _LONGEST_FUNCTION]
    body = _python_body(lines) if is_python else _cpp_body(lines)
    found = [at for at in body if _RETURN.match(lines[at])] or list(body)[-1:]
    return line + found[0] if found else None


def _python_body(lines: Sequence[bytes]) -> Sequence[int]:
    """Return which lines are a function's, behind the first one, without empty ones."""
    head = _indent(lines[0])
    body = []
    for at, text in enumerate(lines[1:], 1):
        if text.strip():
            if _indent(text) <= head and not text.lstrip().startswith(b")"):
                break
            body.append(at)
    return body


def _cpp_body(lines: Sequence[bytes]) -> Sequence[int]:
    """Return which lines are between a function's braces, none where it is only declared."""
    depth, start = 0, None
    for at, text in enumerate(lines):
        if start is None and b";" in text.partition(b"{")[0]:
            return ()
        if start is None and b"{" in text:
            start = at
        depth += text.count(b"{") - text.count(b"}")
        if start is not None and depth <= 0:
            return range(start + 1, at) if at > start + 1 else range(start, start + 1)
    return ()


def _indent(text: bytes) -> int:
    return len(text) - len(text.lstrip())


def _is_python_head(before: bytes) -> bool:
    return _DEF.fullmatch(before) is not None


def _is_cpp_head(before: bytes) -> bool:
    """Tell whether what is before a name on its line is a type, and maybe the name of a class."""
    if _TYPE.fullmatch(before) is None:
        return False
    while before.endswith(b"::"):
        before = before[:-2].rstrip(_LETTERS)
    type_ = before.rstrip(b" \t&*")
    word = _WORD.match(type_)
    return (
        word is not None
        and word[1] not in _NO_TYPES
        and type_ != before
        and (type_.endswith(b">") or type_[-1] in _LETTERS)
    )
