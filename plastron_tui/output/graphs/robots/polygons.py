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
    low, high = min(heights), max(heights)
    first = max(0, floor(low))
    last = min(rows, max(ceil(high), floor(low) + 1))
    if last <= first:
        return
    lefts, rights = [inf] * (last - first), [-inf] * (last - first)
    x, y = points[-1]
    for end_x, end_y in points:
        # From the upper end of the edge to the lower one; this is where pictures take their time.
        if y < end_y:
            top_x, top, bottom_x, bottom = x, y, end_x, end_y
        else:
            top_x, top, bottom_x, bottom = end_x, end_y, x, y
        x, y = end_x, end_y
        slope = (bottom_x - top_x) / (bottom - top) if bottom > top else 0.0
        for row in range(max(first, floor(top)), min(last, floor(bottom) + 1)):
            at = min(max(row + 0.5, low), high)
            if top <= at <= bottom:
                edge = top_x + (at - top) * slope
                number = row - first
                for each in (edge,) if bottom > top else (top_x, bottom_x):
                    if each < lefts[number]:
                        lefts[number] = each
                    if each > rights[number]:
                        rights[number] = each
    for number, (left, right) in enumerate(zip(lefts, rights, strict=True)):
        if left <= right:
            yield Stretch(first + number, left, right)
