"""The height at which each item of a column stands: near its neighbours, apart from the others."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import NamedTuple

from .ordering import Neighbours

_ROUNDS = 12


class Spacing(NamedTuple):
    """How far items of a column are apart: two boxes, and a turning point from anything."""

    boxes: float
    turns: float


PIXELS = Spacing(20.0, 14.0)


def placed(
    neighbours: tuple[Neighbours, Neighbours],
    order: Sequence[Sequence[int]],
    heights: Mapping[int, float],
    ports: Mapping[tuple[int, int], float],
    spacing: Spacing = PIXELS,
) -> dict[int, float]:
    """Return the middle of each item.

    Args:
        neighbours: what each item is joined with on its left, and on its right.
        order: the items of each column from top to bottom.
        heights: those of boxes and turning points.
        ports: of an item and a neighbour, how far off the item's middle the line to the
            neighbour starts, where that is known.
        spacing: how far items are apart.
    """
    left, right = neighbours
    gaps = [_gaps(column, heights, spacing) for column in order]
    middle: dict[int, float] = {}
    for column, apart in zip(order, gaps, strict=True):
        total = sum(apart)
        at = -total / 2
        for item, gap in zip(column, [*apart, 0.0], strict=True):
            middle[item] = at
            at += gap
    for round_ in range(_ROUNDS):
        both = round_ >= _ROUNDS - 4
        forward = round_ % 2 == 0
        for number in range(len(order)) if forward else reversed(range(len(order))):
            column = order[number]
            sides = (left, right) if both else (left,) if forward else (right,)
            wanted, weights = [], []
            for item in column:
                pulls = [
                    (
                        middle[near] + ports.get((near, item), 0.0) - ports.get((item, near), 0.0),
                        _stiffness(item, near),
                    )
                    for side in sides
                    for near in side[item]
                ]
                weight = sum(pull for _, pull in pulls)
                wanted.append(
                    sum(at * pull for at, pull in pulls) / weight if pulls else middle[item]
                )
                weights.append(weight or 0.1)
            middle.update(zip(column, _apart(wanted, weights, gaps[number]), strict=True))
    return middle


def _stiffness(one: int, other: int) -> float:
    """Return how straight a segment wants to be: most of all between two turning points."""
    return (1.0, 3.0, 8.0)[(one < 0) + (other < 0)]


def _gaps(column: Sequence[int], heights: Mapping[int, float], spacing: Spacing) -> list[float]:
    return [
        (heights[upper] + heights[lower]) / 2 + spacing[upper < 0 or lower < 0]
        for upper, lower in pairwise(column)
    ]


def _apart(wanted: Sequence[float], weights: Sequence[float], gaps: Sequence[float]) -> list[float]:
    """Return the places nearest to the wanted ones that keep the gaps.

    Least squares by pooling adjacent violators, on the places less the gaps above them.
    """
    above = [0.0]
    for gap in gaps:
        above.append(above[-1] + gap)
    blocks: list[tuple[float, float, int]] = []
    for place, weight, offset in zip(wanted, weights, above, strict=True):
        total, mass, count = (place - offset) * weight, weight, 1
        while blocks and blocks[-1][0] * mass >= total * blocks[-1][1]:
            last = blocks.pop()
            total, mass, count = total + last[0], mass + last[1], count + last[2]
        blocks.append((total, mass, count))
    flat = [total / mass for total, mass, count in blocks for _ in range(count)]
    return [place + offset for place, offset in zip(flat, above, strict=True)]
