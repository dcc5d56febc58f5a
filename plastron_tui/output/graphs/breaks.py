"""Where a long picture is broken into rows, as text is in a paragraph.

Lengths are in whatever the picture is measured in: cells, or pixels.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

_FEWEST = 3
"""A row has so many columns, unless that is too wide."""


@dataclass(frozen=True, slots=True)
class Strip:
    """A picture's columns in one row.

    Attributes:
        columns: the width of each column.
        gaps: the width of each gap between two columns.
        carried: how many lines run through each gap.
        lane: how much room the line takes that leads from the end of a row to the next one.
        ends: how much room there is beside these lines, at both ends of a row together.
    """

    columns: Sequence[float]
    gaps: Sequence[float]
    carried: Sequence[int]
    lane: float
    ends: float


def breaks_of(strip: Strip, room: float, most_carried: int) -> tuple[int, ...] | None:
    """Return the columns that end a row: as few as can be, then such as carry few lines.

    Args:
        strip: the picture.
        room: how wide a row may be.
        most_carried: so many lines may lead from one row to the next.

    Returns:
        The columns but for the last one, None where the picture cannot be broken so.
    """
    found = _breaks(strip, room, most_carried, _FEWEST)
    return _breaks(strip, room, most_carried, 1) if found is None else found


def _breaks(strip: Strip, room: float, most_carried: int, fewest: int) -> tuple[int, ...] | None:
    """Break a picture into rows of some columns at least."""
    count = len(strip.columns)
    # For each column: the cost of the best rows up to there, and where the row before ends.
    best: list[tuple[tuple[int, int, float], int] | None] = [None] * count
    for last in range(count):
        is_end = last == count - 1
        if not is_end and strip.carried[last] > most_carried:
            continue
        width = strip.columns[last] + strip.ends
        width += 0 if is_end else strip.lane * strip.carried[last]
        for first in range(last, -1, -1):
            if first < last:
                width += strip.columns[first] + strip.gaps[first]
            carried = strip.carried[first - 1] if first else 0
            total = width + strip.lane * carried
            if total > room:
                break
            before = best[first - 1] if first else ((0, 0, 0.0), -1)
            if before is None or last - first + 1 < fewest:
                continue
            rows, crossed, ragged = before[0]
            cost = (rows + 1, crossed + carried, ragged + (room - total) ** 2)
            known = best[last]
            if known is None or cost < known[0]:
                best[last] = cost, first - 1
    found = best[-1]
    if found is None:
        return None
    ends = []
    while found is not None and found[1] >= 0:
        ends.append(found[1])
        found = best[found[1]]
    return tuple(ends[::-1])


def rows_between(cuts: Sequence[int], count: int) -> list[range]:
    """Return the columns of each row, of `count` in all; every row but the last ends in a cut."""
    starts = [0, *(cut + 1 for cut in cuts)]
    return [range(first, end + 1) for first, end in zip(starts, [*cuts, count - 1], strict=True)]
