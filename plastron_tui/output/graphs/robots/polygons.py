"""Filling convex polygons row by row."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import ceil, floor, inf
from typing import NamedTuple

from .views import Point


class Stretch(NamedTuple):
    """What of a row is in a polygon."""

    row: int
    left: float
    right: float


def stretches(points: Sequence[Point], rows: int) -> Iterator[Stretch]:
    """Yield what is in a convex polygon of each row from 0 on, at the middle of the row.

    What is thinner than a row has one all the same, as far as it is not above or below all rows.
    """
    low, high = min(y for _, y in points), max(y for _, y in points)
    first = max(0, floor(low))
    last = min(rows, max(ceil(high), floor(low) + 1))
    if last <= first:
        return
    lefts, rights = [inf] * (last - first), [-inf] * (last - first)
    before = points[-1]
    for point in points:
        upper, lower = (before, point) if before.y < point.y else (point, before)
        before = point
        tall = lower.y - upper.y
        slope = (lower.x - upper.x) / tall if tall else 0.0
        for row in range(max(first, floor(upper.y)), min(last, floor(lower.y) + 1)):
            at = min(max(row + 0.5, low), high)
            if upper.y <= at <= lower.y:
                x = upper.x + (at - upper.y) * slope
                other = x if tall else lower.x
                lefts[row - first] = min(lefts[row - first], x, other)
                rights[row - first] = max(rights[row - first], x, other)
    for row in range(first, last):
        left, right = lefts[row - first], rights[row - first]
        if left <= right:
            yield Stretch(row, left, right)
