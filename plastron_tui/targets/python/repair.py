"""Reading around syntax errors: lines that do not parse are masked, and no offset moves."""

from __future__ import annotations

import ast
import re
import warnings

_MOST_LINES = 24
_OPENS_BLOCK = re.compile(rb"\s*(async\s+)?(def|class|if|elif|else|for|while|try|except|with)\b")


def mask_errors(source: bytes) -> bytes:
    """Return a text of the same length in which the lines with syntax errors do nothing.

    Python itself says which line is wrong. A line that opens a block and lacks its colon gets
    one in place of its last character but one, so that the block still belongs to it.
    """
    lines = source.split(b"\n")
    masked: set[int] = set()
    for _ in range(_MOST_LINES):
        row = _wrong_line(b"\n".join(lines))
        if row is None or row in masked or not 0 <= row < len(lines):
            break
        masked.add(row)
        lines[row] = _mask(lines[row])
    return b"\n".join(lines)


def _wrong_line(source: bytes) -> int | None:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            ast.parse(source)
    except SyntaxError as error:
        return error.lineno - 1 if error.lineno is not None else None
    except (ValueError, RecursionError, MemoryError):
        return None
    return None


def _mask(line: bytes) -> bytes:
    body = line.rstrip()
    ending = line[len(body) :]
    if _OPENS_BLOCK.match(body) and body.endswith(b")") and body[-2:-1].isalnum():
        return body[:-2] + b"):" + ending
    start = len(body) - len(body.lstrip())
    words = b"pass" if len(body) - start >= 4 else b""
    return body[:start] + words.ljust(len(body) - start) + ending
