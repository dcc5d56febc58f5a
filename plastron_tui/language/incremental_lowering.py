"""From an edited text to its statements, by way of those of the text before the edit.

A statement is on a line, and no mistake reaches over the end of its own: only the lines that an
edit touched are parsed and lowered anew, and with them the lines that were broken before, so that
one pass says all that is to say about broken lines. The other statements stay, or move.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Callable
from functools import cache
from operator import attrgetter
from typing import Any, NamedTuple

from plastron_tui.diagnostics import Diagnostic, Span

from .declaration import DECLARATIONS, Statement
from .document import Document
from .lowering import Program, lower

_MOST_BROKEN = 200
"""With more broken lines than this, most of the work is to explain them, and all is done anew."""


@cache
def _values(type_: type[Statement]) -> Callable[[Statement], tuple[Any, ...]]:
    """Return what takes all but its place from a statement, in the order that makes one."""
    return attrgetter("syntax", *(slot.name for slot in DECLARATIONS[type_].slots))


class Lowered(NamedTuple):
    """A text, and the statements that it was lowered to."""

    text: bytes
    program: Program


def lower_edited(document: Document, earlier: Lowered | None) -> Program:
    """Turn a document into what `lower` turns it into, with the help of an earlier text of it.

    Where the earlier text is no help, all is lowered anew.
    """
    text = document.text
    if earlier is None or b"/*" in earlier.text or b"/*" in text:
        # A block comment can join lines, and take those that follow for its own.
        return lower(document)
    before, program = earlier
    if text == before:
        return program
    old, new = _changed_lines(before, text)
    is_large = 2 * (new.end - new.start) > len(text)
    if is_large or len(program.diagnostics) > _MOST_BROKEN:
        return lower(document)
    return _Excerpts(program, before, text, old, new).lowered()


class _Excerpts:
    """The lines of a text that are lowered anew, put together to a text of their own."""

    def __init__(self, program: Program, before: bytes, text: bytes, old: Span, new: Span) -> None:
        self._program = program
        self._old = old
        self._by = new.end - old.end
        broken = {_line(before, found) for found in program.diagnostics}
        outside = [line for line in broken if line.end <= old.start or line.start >= old.end]
        moved = [line.moved(self._by if line.start >= old.end else 0) for line in outside]
        self._lines = sorted([*moved, new])
        # A byte order mark is nothing at the start of a file, and only there.
        parts = [b"\n"] if self._lines[0].start else []
        self._starts = []
        at = len(parts)
        for start, end in self._lines:
            self._starts.append(at)
            parts.append(text[start:end])
            at += end - start
        self._text = b"".join(parts)

    def lowered(self) -> Program:
        """Return the whole program."""
        found = lower(Document(self._text))
        statements = self._program.statements
        first = bisect_left(statements, self._old.start, key=_start)
        last = bisect_left(statements, self._old.end, key=_start)
        made = [_moved(each, self._distance(each.span)) for each in found.statements]
        after = statements[last:]
        if self._by:
            after = tuple([_moved(each, self._by) for each in after])
        diagnostics = [
            each.moved(0 if each.span is None else self._distance(each.span))
            for each in found.diagnostics
        ]
        undecided = [
            each._replace(span=each.span.moved(self._distance(each.span)))
            for each in found.broken.undecided
        ]
        broken = found.broken._replace(undecided=tuple(undecided))
        return Program((*statements[:first], *made, *after), tuple(diagnostics), broken)

    def _distance(self, span: Span) -> int:
        """Return how far a place is from where it is in the whole text."""
        index = max(0, bisect_right(self._starts, span.start) - 1)
        return self._lines[index].start - self._starts[index]


def _start(statement: Statement) -> int:
    return statement.span.start


def _moved(statement: Statement, by: int) -> Statement:
    """Return a statement that stands elsewhere."""
    type_: Any = type(statement)  # which mypy takes for not hashable
    start, end = statement.span
    made: Statement = type_(Span(start + by, end + by), *_values(type_)(statement))
    return made


def _line(text: bytes, found: Diagnostic) -> Span:
    """Return the line of a mistake, its newline included."""
    at = 0 if found.span is None else found.span.start
    return _lines_around(text, at, at)


def _lines_around(text: bytes, start: int, end: int) -> Span:
    """Return the lines that two offsets are in, and what is between them."""
    newline = text.find(b"\n", end)
    return Span(text.rfind(b"\n", 0, start) + 1, len(text) if newline < 0 else newline + 1)


def _changed_lines(before: bytes, text: bytes) -> tuple[Span, Span]:
    """Return the lines in which two texts differ, in the one and in the other."""
    least = min(len(before), len(text))
    same = _longest(least, lambda low, high: before[low:high] == text[low:high])
    left = least - same
    at_end = _longest(
        left,
        lambda low, high: (
            before[len(before) - high : len(before) - low]
            == text[len(text) - high : len(text) - low]
        ),
    )
    old = _lines_around(before, same, len(before) - at_end)
    return old, Span(old.start, old.end + len(text) - len(before))


def _longest(most: int, is_same: Callable[[int, int], bool]) -> int:
    """Return up to where two texts are the same; `is_same` compares a part of them."""
    low, high = 0, most
    while low < high:
        middle = (low + high + 1) // 2
        if is_same(low, middle):
            low = middle
        else:
            high = middle - 1
    return low
