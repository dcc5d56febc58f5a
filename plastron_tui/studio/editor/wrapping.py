"""Where a long line is broken to fit a width."""

from __future__ import annotations

from .columns import Line


def sections(line: Line, width: int) -> list[tuple[int, int]]:
    """Return the pieces of a line, in byte columns, none wider than `width` cells.

    A piece ends after a space where it has one, so that words stay whole.
    """
    found: list[tuple[int, int]] = []
    start = 0
    while start < line.size:
        end = line.column(line.cell(start) + width)
        if end >= line.size and line.width - line.cell(start) <= width:
            break
        end = max(end, line.next_stop(start))
        space = line.piece(start, end).rfind(" ") if end < line.size else -1
        if space > 0 and len(line.piece(start, end)) == end - start:
            end = start + space + 1
        found.append((start, end))
        start = end
    found.append((start, line.size))
    return found
