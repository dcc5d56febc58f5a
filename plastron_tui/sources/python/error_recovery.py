"""Reading around what does not parse, without moving an offset."""

from __future__ import annotations

import re

from .compiling import syntax_error

_MOST_LINES = 24
_WIDEST_INDENT = 255
"""In columns. Blocks within blocks have indents that grow, so that there are no more of them."""

# The scanner adds up what stands before and after a backslash at the end of a line.
_INDENT = re.compile(rb"^(?:[ \t\f\r]|\\\r?\n){32,}", re.MULTILINE)
_NO_COLUMN = bytes.maketrans(b" \t", b"\f\f")
_TAB_AFTER_SPACE = re.compile(rb"^[ \t]* \t[ \t]*", re.MULTILINE)
_OPENS_BLOCK = re.compile(rb"\s*(async\s+)?(def|class|if|elif|else|for|while|try|except|with)\b")


def straighten(source: bytes) -> bytes:
    """Return a text of the same length that the grammar indents as Python 2 does.

    A tab goes to the next multiple of eight columns there, whatever spaces stand before it; for
    the grammar it is eight columns wide. A form feed sets the column to zero for both.
    """
    return _TAB_AFTER_SPACE.sub(_straightened, source)


def _straightened(indent: re.Match[bytes]) -> bytes:
    column = len(indent[0].expandtabs(8))
    straight = b"\t" * (column // 8) + b" " * (column % 8)
    return straight.rjust(len(indent[0]), b"\f")


def bound_indents(source: bytes) -> bytes:
    """Return a text of the same length in which no line is indented by more than 255 columns.

    The scanner of tree-sitter-python has room for some 500 blocks within each other, and crashes
    at more; Python itself reads 100.
    """
    return _INDENT.sub(_bounded, source)


def _bounded(indent: re.Match[bytes]) -> bytes:
    text = indent[0]
    if text.count(b" ") + 8 * text.count(b"\t") <= _WIDEST_INDENT:
        return text
    start = max(text.rfind(b"\n") + 1, len(text) - _WIDEST_INDENT)
    return text[:start].translate(_NO_COLUMN) + b" " * (len(text) - start)


def mask_errors(source: bytes) -> bytes:
    """Return a text of the same length in which the lines with syntax errors do nothing.

    Python itself says which line is wrong. A line that opens a block and lacks its colon gets
    one in place of its last character but one, so that the block still belongs to it.
    """
    lines = source.split(b"\n")
    masked: set[int] = set()
    for _ in range(_MOST_LINES):
        wrong = syntax_error(b"\n".join(lines))
        if wrong is None or wrong.line is None:
            break
        row = wrong.line - 1
        if row in masked or not 0 <= row < len(lines):
            break
        masked.add(row)
        lines[row] = _mask(lines[row])
    return b"\n".join(lines)


def _mask(line: bytes) -> bytes:
    body = line.rstrip()
    ending = line[len(body) :]
    if _OPENS_BLOCK.match(body) and body.endswith(b")") and body[-2:-1].isalnum():
        return body[:-2] + b"):" + ending
    start = len(body) - len(body.lstrip())
    words = b"pass" if len(body) - start >= 4 else b""
    return body[:start] + words.ljust(len(body) - start) + ending
