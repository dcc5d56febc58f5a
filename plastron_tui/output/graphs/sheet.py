"""What is laid out as a picture of characters, and what can be said of it before that."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple

from .breaks import Strip, breaks_of, rows_between
from .layers import Between, Columns, Net, nets_between

BEFORE, BEHIND = 2, 1
"""Cells between a lane and a box on its right, which an arrow head needs, and on its left."""
FEW_CARRIED, MOST_CARRIED = 2, 8
"""So many lines lead from row to row of a picture that is read with ease, and so many at most."""


class Measure(NamedTuple):
    """How large a box has to be: its width, the rows of its text, and those of its frame."""

    width: int
    rows: int
    frame: int


@dataclass(frozen=True)
class Sheet:
    """What is laid out, and how tight.

    Attributes:
        columns: the boxes and turning points by column.
        order: the columns, each from top to bottom.
        measures: how large each box has to be.
        track: how far lanes are apart.
        between: the rows between two boxes.
    """

    columns: Columns
    order: Sequence[Sequence[int]]
    measures: Mapping[int, Measure]
    track: int
    between: int

    @cached_property
    def nets(self) -> list[Between]:
        """The nets between each two columns."""
        return nets_between(self.columns)

    @cached_property
    def heights(self) -> dict[int, int]:
        """The rows of each item: those of its text, or of the lines at one of its sides."""
        return _heights(self)

    @cached_property
    def widths(self) -> list[int]:
        """The width of each column."""
        return [
            max((self.measures[item].width for item in items if item >= 0), default=1)
            for items in self.order
        ]

    @cached_property
    def column_heights(self) -> list[int]:
        """The least height of each column."""
        return [
            sum(self.heights[item] for item in items)
            + sum(self.apart(one, other) for one, other in pairwise(items))
            for items in self.order
        ]

    def apart(self, upper: int, lower: int) -> int:
        """Return the rows between two items of a column."""
        return self.between if upper >= 0 and lower >= 0 else 0


class Estimate(NamedTuple):
    """What can be said of a picture for a room without laying it out.

    Attributes:
        cuts: the columns that end a row, but for the last one.
        width: more than the room if the picture cannot be made to fit.
        height: the least height, if it fits.
    """

    cuts: tuple[int, ...]
    width: int
    height: int


def estimate(sheet: Sheet, room: int, most_carried: int = MOST_CARRIED) -> Estimate:
    """Tell how a picture can be broken so that it fits into a room, if it is broken at all."""
    width = sum(sheet.widths) + len(sheet.nets) * (BEHIND + sheet.track + BEFORE)
    cuts: tuple[int, ...] = ()
    if width > room:
        cuts = breaks_of(_estimated_strip(sheet), room, most_carried) or ()
    height = sum(len(sheet.nets[cut]) for cut in cuts)
    height += sum(
        max(sheet.column_heights[at] for at in row) for row in rows_between(cuts, len(sheet.order))
    )
    return Estimate(cuts, 0 if cuts else width, height)


def _estimated_strip(sheet: Sheet) -> Strip:
    """Return how wide everything is where each net between two columns needs a lane."""
    return strip_of(sheet, [BEHIND + len(nets) * sheet.track + BEFORE for nets in sheet.nets])


def strip_of(sheet: Sheet, gaps: Sequence[float]) -> Strip:
    """Return how wide everything is."""
    carried = [len(nets) for nets in sheet.nets]
    return Strip(sheet.widths, gaps, carried, sheet.track, BEFORE + BEHIND)


def _heights(sheet: Sheet) -> dict[int, int]:
    """Return the rows of each item: those of its text, or of the lines at one of its sides."""
    nets: dict[tuple[int, bool], set[Net]] = {}
    for link, route in sheet.columns.routes.items():
        nets.setdefault((route[0], False), set()).add(sheet.columns.nets[link])
        nets.setdefault((route[-1], True), set()).add(sheet.columns.nets[link])
    heights = {}
    for item in sheet.columns.column_of:
        if item < 0:
            heights[item] = 1
            continue
        measure = sheet.measures[item]
        lines = max(len(nets.get((item, is_left), ())) for is_left in (False, True))
        heights[item] = max(measure.rows, lines) + 2 * measure.frame
    return heights
