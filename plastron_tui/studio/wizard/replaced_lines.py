"""Lines of a program that give way to what the wizard writes."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import takewhile

from plastron_tui.diagnostics import Edit, Span


def line_of(text: bytes, span: Span) -> Span:
    """Return the lines of a text that a span is in, with the end of the last one."""
    end = text.find(b"\n", span.end)
    return Span(text.rfind(b"\n", 0, span.start) + 1, len(text) if end < 0 else end + 1)


def moved(span: Span, start: int, by: int) -> Span:
    """Return where a span is once the text has grown before it, at `start`."""
    return Span(span.start + by, span.end + by) if span.start >= start else span


def without(span: Span, gone: Sequence[Span]) -> Span:
    """Return where a span is once others, none of which it touches, have been taken away."""
    before = sum(each.end - each.start for each in gone if each.end <= span.start)
    return Span(span.start - before, span.end - before)


def whole_edit(old: bytes, new: bytes) -> Edit:
    """Return the one edit, of whole lines, that makes a text another one."""
    before, after = old.splitlines(keepends=True), new.splitlines(keepends=True)
    head = _alike(before, after)
    tail = _alike(before[head:][::-1], after[head:][::-1])
    start = sum(map(len, before[:head]))
    end = len(old) - sum(map(len, before[len(before) - tail :]))
    written = b"".join(after[head : len(after) - tail])
    return Edit(Span(start, end), written.decode("utf-8", "surrogatepass"))


def _alike(one: Sequence[bytes], other: Sequence[bytes]) -> int:
    """Return how many lines two texts begin with alike."""
    pairs = zip(one, other, strict=False)
    return sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], pairs))
