"""Filling convex polygons row by row."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import ceil, floor, inf
from typing import NamedTuple


class Stretch(NamedTuple):
    """What of a row is in a polygon."""

    row: int
    left: float
    right: float


def stretches(points: Sequence[tuple[float, float]], rows: int) -> Iterator[Stretch]:
    """Yield what is in a convex polygon of each row from 0 on, at the middle of the row.

    What is thinner than a row has one all the same, as far as it is not above or below all rows.
    """
    heights = [y for _, y in points]
    found = middles(min(heights), max(heights), rows)
    if not found:
        return
    first, last = found[0][0], found[-1][0]
    lefts, rights = [inf] * len(found), [-inf] * len(found)
    x, y = points[-1]
    for end_x, end_y in points:
        # From the upper end of the edge to the lower one; this is where pictures take their time.
        if y < end_y:
            top_x, top, bottom_x, bottom = x, y, end_x, end_y
        else:
            top_x, top, bottom_x, bottom = end_x, end_y, x, y
        x, y = end_x, end_y
        slope = (bottom_x - top_x) / (bottom - top) if bottom > top else 0.0
        start, end = max(first, floor(top)), min(last, floor(bottom))
        for number in range(start - first, end - first + 1):
            at = found[number][1]
            if top <= at <= bottom:
                edge = top_x + (at - top) * slope
                for each in (edge,) if bottom > top else (top_x, bottom_x):
                    if each < lefts[number]:
                        lefts[number] = each
                    if each > rights[number]:
                        rights[number] = each
    for (row, _), left, right in zip(found, lefts, rights, strict=True):
        if left <= right:
            yield Stretch(row, left, right)


def middles(low: float, high: float, rows: int) -> list[tuple[int, float]]:
    """Return the rows whose middles are between two heights, each with that height.

    Where there is none, it is the row that they are in, and the height between them.
    """
    first, last = ceil(low - 0.5), floor(high - 0.5)
    if first > last:
        row = floor((low + high) / 2)
        return [(row, (low + high) / 2)] if 0 <= row < rows else []
    return [(row, row + 0.5) for row in range(max(first, 0), min(last, rows - 1) + 1)]
