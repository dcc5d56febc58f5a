"""What is said about a word of a program, as data: a title, and rows below it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import NamedTuple

from rich.cells import cell_len, set_cell_size

from plastron_tui.diagnostics import Span
from plastron_tui.diagnostics.terminal import visible

from ..cells import cut

_WIDEST_LABEL = 24
_INDENT = 2


class CardRow(NamedTuple):
    """A row of a card.

    Attributes:
        label: what stands in the first column; "" where it is that of the row above.
        text: what is said of it; "" where the label says all, over both columns.
        note: what is said besides, quietly.
        is_warning: whether it says that something is wrong.
    """

    label: str
    text: str = ""
    note: str = ""
    is_warning: bool = False


@dataclass(frozen=True, slots=True)
class Card:
    """What is said about a word.

    Attributes:
        span: where the word is.
        title: what it is called.
        kind: what it is, such as `message type`.
        rows: what is known of it.
    """

    span: Span
    title: str
    kind: str
    rows: tuple[CardRow, ...]

    def with_row(self, label: str, text: str) -> Card:
        """Return the card with a row above the others."""
        return replace(self, rows=(CardRow(label, text), *self.rows))

    def with_hint(self, hint: str) -> Card:
        """Return the card with a hint below it."""
        return replace(self, rows=(*self.rows, CardRow("", "", hint)))


class Run(NamedTuple):
    """Characters that look alike: `tone` is "", `title`, `quiet` or `warning`."""

    text: str
    tone: str


CardLine = tuple[Run, ...]


def lines_of(card: Card, width: int) -> list[CardLine]:
    """Lay a card out in lines of so many cells; nothing in it controls a terminal."""
    rows = [row._replace(label=visible(row.label)) for row in card.rows]
    labels = [cell_len(row.label) for row in rows if row.text or row.note]
    column = min(max(labels, default=0), _WIDEST_LABEL, max(1, width // 2))
    lines = [_title(card, width)]
    for row in rows:
        lines += _laid_out(row, column, width)
    return lines


def _title(card: Card, width: int) -> CardLine:
    title, kind = visible(card.title), visible(card.kind)
    if cell_len(title) + cell_len(kind) + _INDENT > width:
        return (Run(cut(title, width), "title"),)
    return (Run(title, "title"), Run(f"{' ' * _INDENT}{kind}", "quiet"))


def _laid_out(row: CardRow, column: int, width: int) -> Iterator[CardLine]:
    """Yield the lines of a row: what is long goes on below the place where it began."""
    tone = "warning" if row.is_warning else ""
    words = [(word, tone) for word in visible(row.text).split(" ") if word]
    words += [(word, "quiet") for word in visible(row.note).split(" ") if word]
    if not words:
        yield from _wrapped([(word, tone) for word in row.label.split(" ")], 0, width, ())
        return
    start = column + _INDENT
    if cell_len(row.label) > column:
        yield (Run(cut(row.label, width), ""),)
        yield from _wrapped(words, start, width, (Run(" " * start, ""),))
        return
    label = set_cell_size(row.label, column) + " " * _INDENT
    yield from _wrapped(words, start, width, (Run(label, ""),))


def _wrapped(
    words: list[tuple[str, str]], start: int, width: int, first: CardLine
) -> Iterator[CardLine]:
    """Yield lines of words, the first behind what is there, the others as far in."""
    line, at = list(first), start
    is_fresh = True
    for word, tone in words:
        shown = cut(word, max(1, width - start))
        if not is_fresh and at + 1 + cell_len(shown) > width:
            yield tuple(line)
            line, at, is_fresh = [Run(" " * start, "")] if start else [], start, True
        text = shown if is_fresh else f" {shown}"
        line.append(Run(text, tone))
        at += cell_len(text)
        is_fresh = False
    yield tuple(line)
