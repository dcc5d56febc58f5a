"""Lines that are longer than there is room for, folded: all of them is in sight."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import groupby

from rich.cells import get_character_cell_size

from .styles import Line, Lines, Piece, rest_of

_MARKS = frozenset("([{,.=/")
"""What a line is split behind where it has no space to be split at."""
_MORE = 4
"""Columns by which the rest of a line stands further in than its start."""

_START = re.compile(r"(?: *\d+ [ +-]|[+-])? *")
"""What stands before the text of a line: its number and its mark in a diff, and its indent."""

_EMPTY = 4
"""A row of which less than this part is used would be nearly empty."""

_ROOMY = 16
"""With fewer columns the rest of a line that is far in begins at the left."""

Cell = tuple[str, str]
"""A character and its tone."""


def folded(lines: Lines, width: int) -> Lines:
    """Return lines, of those that are too long the rest below them, further in.

    A line is split behind a space, or else a mark, where that does not leave a row nearly empty.
    The rest of a line that begins far to the right begins at the middle, at most.

    Args:
        lines: coloured lines.
        width: how many columns there are.
    """
    return tuple(row for line in lines for row in _rows(line, max(width, 2)))


def _rows(line: Line, width: int) -> Iterator[Line]:
    if sum(len(piece.text) for piece in line) * 2 <= width:
        yield line
        return
    cells = [(character, piece.tone) for piece in line for character in piece.text]
    text = "".join(character for character, _ in cells)
    before_text = _START.match(text)
    lead = 0 if before_text is None else before_text.end()
    indent = lead + _MORE
    at_most = width // 2
    before = " " * (min(indent, at_most) if width >= _ROOMY or indent <= at_most else 0)
    end = _end(cells, width, lead)
    rest = rest_of(line)
    yield (*_joined(cells[:end]), *rest) if end < len(cells) else line
    while end < len(cells):
        start, room = end, width - len(before)
        end += _end(cells[start:], room)
        space = (Piece(before, *(tone for _, tone in rest)),) if before else ()
        yield (*space, *_joined(cells[start:end]), *rest)


def _end(cells: list[Cell], width: int, lead: int = 0) -> int:
    """Return how many characters fit into a row, one at least.

    Args:
        cells: the characters that are left.
        width: how many columns there are.
        lead: how many characters there are before the text itself.
    """
    used, after_space, after_mark, begins = 0, 0, 0, False
    for number, (character, _) in enumerate(cells):
        used += get_character_cell_size(character)
        if used > width and number:
            good = (end for end in (after_space, after_mark) if end * _EMPTY > number)
            return next(good, number)
        begins = begins or (number >= lead and character != " ")
        if character == " " and begins:
            after_space = number + 1
        elif character in _MARKS:
            after_mark = number + 1
    return len(cells)


def _joined(cells: list[Cell]) -> Line:
    """Return a line of characters, those of one tone as one piece."""
    return tuple(
        Piece("".join(character for character, _ in group), tone)
        for tone, group in groupby(cells, key=lambda cell: cell[1])
    )
