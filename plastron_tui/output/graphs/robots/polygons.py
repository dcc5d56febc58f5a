"""Filling convex polygons row by row."""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil, floor, inf
from typing import TypeAlias

Stretch: TypeAlias = tuple[int, float, float]
"""What of a row is in a polygon: the row, its left end and its right one."""


def stretches(points: Sequence[tuple[float, float]], rows: int) -> list[Stretch]:
    """Return what is in a convex polygon of each row from 0 on, at the middle of the row.

    What is thinner than a row has one all the same, as far as it is not above or below all rows.
    """
    heights = [y for _, y in points]
    found = middles(min(heights), max(heights), rows)
    if not found:
        return []
    first, count = found[0][0], len(found)
    # Where between its edges a row is looked at; this is where pictures take their time.
    within = found[0][1] - first
    lefts, rights = [inf] * count, [-inf] * count
    x, y = points[-1]
    for end_x, end_y in points:
        start_x, start_y, x, y = x, y, end_x, end_y
        # From the upper end of the edge to the lower one.
        if start_y < end_y:
            top_x, top, bottom_x, bottom = start_x, start_y, end_x, end_y
        else:
            top_x, top, bottom_x, bottom = end_x, end_y, start_x, start_y
        low, high = ceil(top - within) - first, floor(bottom - within) - first
        numbers = range(low if low > 0 else 0, (high if high < count else count - 1) + 1)
        if not numbers:
            continue
        if bottom == top:
            for number in numbers:
                lefts[number] = min(lefts[number], top_x, bottom_x)
                rights[number] = max(rights[number], top_x, bottom_x)
            continue
        slope = (bottom_x - top_x) / (bottom - top)
        above = first + within - top
        for number in numbers:
            edge = top_x + (number + above) * slope
            if edge < lefts[number]:
                lefts[number] = edge
            if edge > rights[number]:
                rights[number] = edge
    there = zip(range(first, first + count), lefts, rights, strict=True)
    return [each for each in there if each[1] <= each[2]]


def middles(low: float, high: float, rows: int) -> list[tuple[int, float]]:
    """Return the rows whose middles are between two heights, each with that height.

    Where there is none, it is the row that they are in, and the height between them.
    """
    first, last = ceil(low - 0.5), floor(high - 0.5)
    if first > last:
        row = floor((low + high) / 2)
        return [(row, (low + high) / 2)] if 0 <= row < rows else []
    return [(row, row + 0.5) for row in range(max(first, 0), min(last, rows - 1) + 1)]
