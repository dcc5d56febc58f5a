"""Where a cursor goes: pure functions from an offset to an offset."""

from __future__ import annotations

from collections.abc import Iterable

from .buffer import Buffer
from .columns import is_word

_PAIRS = {ord("("): ord(")"), ord("["): ord("]"), ord("{"): ord("}")}
_BACK = {close: opened for opened, close in _PAIRS.items()}
_FARTHEST_BRACKET = 20_000


def left(buffer: Buffer, offset: int) -> int:
    """Return the place of the character before, or the end of the row before."""
    row = buffer.row(offset)
    start = buffer.start(row)
    if offset == start:
        return buffer.end(row - 1) if row else 0
    return start + buffer.line(row).previous_stop(offset - start)


def right(buffer: Buffer, offset: int) -> int:
    """Return the place after the character, or the start of the next row."""
    row = buffer.row(offset)
    if offset >= buffer.end(row):
        return buffer.next_start(row)
    start = buffer.start(row)
    return start + buffer.line(row).next_stop(offset - start)


def word_left(buffer: Buffer, offset: int) -> int:
    """Return the start of the word before, over the end of a row if need be."""
    row = buffer.row(offset)
    start = buffer.start(row)
    if offset == start:
        return left(buffer, offset)
    text = buffer.text
    at = offset
    while at > start and text[at - 1] in b" \t":
        at -= 1
    if at == start:
        return start
    kind = is_word(text[at - 1])
    while at > start and is_word(text[at - 1]) is kind and text[at - 1] not in b" \t":
        at -= 1
    return at


def word_right(buffer: Buffer, offset: int) -> int:
    """Return the start of the next word, or the end of the row."""
    row = buffer.row(offset)
    end = buffer.end(row)
    if offset >= end:
        return right(buffer, offset)
    text = buffer.text
    at = offset
    kind = is_word(text[at])
    while at < end and is_word(text[at]) is kind and text[at] not in b" \t":
        at += 1
    while at < end and text[at] in b" \t":
        at += 1
    return at


def line_start(buffer: Buffer, offset: int) -> int:
    """Return the first character of the row that is no space; from there, the row's start."""
    row = buffer.row(offset)
    start, end = buffer.start(row), buffer.end(row)
    at = start
    while at < end and buffer.text[at] in b" \t":
        at += 1
    return start if offset == at else at


def line_end(buffer: Buffer, offset: int) -> int:
    """Return the end of the row."""
    return buffer.end(buffer.row(offset))


def text_start(buffer: Buffer, offset: int) -> int:
    """Return the start of the text."""
    return 0


def text_end(buffer: Buffer, offset: int) -> int:
    """Return the end of the text."""
    return buffer.size


def word_at(buffer: Buffer, offset: int) -> tuple[int, int]:
    """Return the word around an offset, or the one character there."""
    row = buffer.row(offset)
    low, high = buffer.start(row), buffer.end(row)
    text = buffer.text
    start = end = offset
    while start > low and is_word(text[start - 1]):
        start -= 1
    while end < high and is_word(text[end]):
        end += 1
    if start == end and end < high:
        return offset, right(buffer, offset)
    return start, end


def matching_brackets(
    buffer: Buffer, offset: int, literal: Iterable[tuple[int, int]] = ()
) -> tuple[int, int] | None:
    """Return the bracket at or before an offset, and the one that closes or opens it.

    Brackets match within their row, as statements do.

    Args:
        buffer: the text.
        offset: where the cursor is.
        literal: the strings and comments of the row, in byte columns; there a bracket is none.
    """
    row = buffer.row(offset)
    start = buffer.start(row)
    line = bytearray(buffer.line_bytes(row))
    for begin, end in literal:
        line[begin:end] = b" " * len(line[begin:end])
    column = offset - start
    for at in (column, column - 1):
        if 0 <= at < len(line) and (line[at] in _PAIRS or line[at] in _BACK):
            other = _partner(line, at)
            return None if other is None else (start + at, start + other)
    return None


def _partner(line: bytearray, at: int) -> int | None:
    mine = line[at]
    forward = mine in _PAIRS
    theirs = _PAIRS[mine] if forward else _BACK[mine]
    most = min(len(line), at + _FARTHEST_BRACKET)
    places = range(at, most) if forward else range(at, max(-1, at - _FARTHEST_BRACKET), -1)
    depth = 0
    for place in places:
        byte = line[place]
        if byte == mine:
            depth += 1
        elif byte == theirs:
            depth -= 1
            if not depth:
                return place
    return None
