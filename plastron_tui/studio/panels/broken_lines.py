"""Lines that are broken where a panel ends."""

from __future__ import annotations

from rich.cells import cell_len, get_character_cell_size

from .styles import Line, Lines, Piece

_STOPS = " ,("
"""The characters behind which a line may be broken."""


def broken(line: Line, width: int, indent: int) -> Lines:
    """Break a line into rows of at most so many cells, all but the first with an indent."""
    text = "".join(piece.text for piece in line)
    if cell_len(text) <= width:
        return (line,)
    rows: list[Line] = []
    start = 0
    while start < len(text):
        margin = indent if rows else 0
        room = max(1, width - margin)
        end = _end(text, start, room)
        if end < len(text):
            stop = max(text.rfind(stop, start, end) for stop in _STOPS) + 1
            # Next to nothing would be in this row otherwise.
            end = stop if stop - start > room // 2 else end
        rows.append((*([Piece(" " * margin)] if margin else []), *_cut(line, start, end)))
        start = end
    return tuple(rows)


def _end(text: str, start: int, room: int) -> int:
    """Return where so many cells of a text end; one character at least goes in."""
    if text.isascii():
        return min(start + room, len(text))
    end = start
    while end < len(text):
        room -= get_character_cell_size(text[end])
        if room < 0 and end > start:
            break
        end += 1
    return end


def _cut(line: Line, start: int, end: int) -> Line:
    """Return the pieces of a line between two of its characters."""
    found = []
    at = 0
    for text, tone in line:
        part = text[max(0, start - at) : max(0, end - at)]
        if part:
            found.append(Piece(part, tone))
        at += len(text)
    return tuple(found)
