"""Where a long line is broken to fit a width."""

from __future__ import annotations

from functools import lru_cache

from .columns import Line

_LONGEST_WORD = 40
"""Of a longer word nobody minds where it is broken; a line may be one of 100,000 characters."""


@lru_cache(4096)
def sections(line: Line, width: int) -> tuple[tuple[int, int], ...]:
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
        end = _after_space(line, start, end)
        found.append((start, end))
        start = end
    found.append((start, line.size))
    return tuple(found)


def _after_space(line: Line, start: int, end: int) -> int:
    """Return the column after the last space of a piece, its end if it has none."""
    at = line.last_space(max(start, end - _LONGEST_WORD), end)
    return end if at is None else line.next_stop(at)
