"""The order within columns: few crossings, by barycentres and exchanges of neighbours."""

from __future__ import annotations

from bisect import bisect_right, insort
from collections.abc import Container
from itertools import pairwise

from .layers import Columns

_SWEEPS = 24
_MOST_EXCHANGED = 900
Neighbours = dict[int, list[int]]


def neighbours_of(columns: Columns, cuts: Container[int] = ()) -> tuple[Neighbours, Neighbours]:
    """Return what each box and turning point is joined with on its left, and on its right.

    What is joined across the gap behind one of the columns `cuts` is left out.
    """
    left: Neighbours = {item: [] for item in columns.column_of}
    right: Neighbours = {item: [] for item in columns.column_of}
    for one, other in columns.segments:
        if columns.column_of[one] not in cuts:
            right[one].append(other)
            left[other].append(one)
    return left, right


def ordered(columns: Columns) -> list[list[int]]:
    """Return the columns with the items of each from top to bottom."""
    left, right = neighbours_of(columns)
    order = [list(column) for column in columns.columns]
    best = [list(column) for column in order]
    fewest = crossings(order, right)
    stale = 0
    for sweep in range(_SWEEPS):
        if fewest == 0 or stale > 5:
            break
        _sweep(order, left if sweep % 2 == 0 else right, forward=sweep % 2 == 0)
        if len(columns.column_of) <= _MOST_EXCHANGED:
            _exchange(order, left, right)
        count = crossings(order, right)
        stale += 1
        if count < fewest:
            fewest, best, stale = count, [list(column) for column in order], 0
    return best


def crossings(order: list[list[int]], right: Neighbours) -> int:
    """Count the crossings of links between adjacent columns."""
    total = 0
    for column, following in pairwise(order):
        at = {item: place for place, item in enumerate(following)}
        above: list[int] = []
        for item in column:
            ends = sorted(at[near] for near in right[item])
            total += sum(len(above) - bisect_right(above, end) for end in ends)
            for end in ends:
                insort(above, end)
    return total


def _sweep(order: list[list[int]], near: Neighbours, *, forward: bool) -> None:
    """Sort each column by the mean place of its items' neighbours in the column before."""
    numbers = range(1, len(order)) if forward else range(len(order) - 2, -1, -1)
    for number in numbers:
        fixed = order[number - 1 if forward else number + 1]
        at = {item: place for place, item in enumerate(fixed)}
        # What has no neighbour there stays about where it is.
        scale = len(fixed) / max(len(order[number]), 1)
        mean = {
            item: sum(at[other] for other in near[item]) / len(near[item])
            if near[item]
            else place * scale
            for place, item in enumerate(order[number])
        }
        order[number].sort(key=mean.__getitem__)


def _exchange(order: list[list[int]], left: Neighbours, right: Neighbours) -> None:
    """Exchange neighbours in a column as long as that saves crossings."""
    for number, column in enumerate(order):
        sides = []
        if number > 0:
            sides.append((left, {item: at for at, item in enumerate(order[number - 1])}))
        if number + 1 < len(order):
            sides.append((right, {item: at for at, item in enumerate(order[number + 1])}))
        for at in range(len(column) - 1):
            upper, lower = column[at], column[at + 1]
            gain = 0
            for near, places in sides:
                gain += _gain(
                    [places[item] for item in near[upper]], [places[item] for item in near[lower]]
                )
            if gain > 0:
                column[at], column[at + 1] = lower, upper


def _gain(upper: list[int], lower: list[int]) -> int:
    """Return how many crossings the exchange of two neighbours saves."""
    return sum((one > other) - (one < other) for one in upper for other in lower)
