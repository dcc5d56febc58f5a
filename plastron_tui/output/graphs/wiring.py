"""The lines of a picture of characters, once it is known where everything is."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import NamedTuple

from .lanes import Turn
from .layers import Net
from .sheet import BEFORE, BEHIND, Sheet


class Place(NamedTuple):
    """Where a box is, in cells."""

    x: int
    y: int
    width: int
    height: int


class Run(NamedTuple):
    """A straight piece of a line, both ends included: level, or upright."""

    x: int
    y: int
    to_x: int
    to_y: int


class Head(NamedTuple):
    """An arrow head: the last cell of a line before a box."""

    x: int
    y: int
    to_right: bool


class Wire(NamedTuple):
    """Lines of a net: where they run, and where they reach their goals."""

    net: Net
    runs: tuple[Run, ...]
    heads: tuple[Head, ...]


class Gap(NamedTuple):
    """The nets between two columns: what they join, the rows at which they do, and their lanes."""

    nets: tuple[Net, ...]
    turns: tuple[Turn, ...]
    items: tuple[tuple[list[int], list[int]], ...]
    lanes: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Frame:
    """Where everything is.

    Attributes:
        sheet: what is drawn.
        places: where the boxes are.
        tops: the first row of each box and each turning point.
        starts: where the columns begin.
        indent: where the rows of columns begin.
        gaps: what is between the columns.
        channels: for each column that ends a row the first row below it, where lines lead back.
    """

    sheet: Sheet
    places: Mapping[int, Place]
    tops: Mapping[int, int]
    starts: Mapping[int, int]
    indent: int
    gaps: tuple[Gap, ...]
    channels: Mapping[int, int]


def wires_of(frame: Frame) -> Iterator[Wire]:
    """Yield the lines: between columns, across columns, and from row to row."""
    for column, gap in enumerate(frame.gaps):
        if column in frame.channels:
            yield from _carried(frame, column, gap)
        else:
            yield from _turning(frame, column, gap)
    seen = set()
    for link, route in frame.sheet.columns.routes.items():
        for item in route[1:-1]:
            if item not in seen:
                seen.add(item)
                yield _level(frame, frame.sheet.columns.nets[link], item)


def _level(frame: Frame, net: Net, item: int) -> Wire:
    """Return the line through a turning point, which runs level across its column."""
    column = frame.sheet.columns.column_of[item]
    x, row = frame.starts[column], frame.tops[item]
    return Wire(net, (Run(x - 1, row, x + frame.sheet.widths[column], row),), ())


def _turning(frame: Frame, column: int, gap: Gap) -> Iterator[Wire]:
    """Yield the lines between two columns of a row."""
    first = _edge(frame, column) + BEHIND
    for number, (net, turn, lane) in enumerate(zip(gap.nets, gap.turns, gap.lanes, strict=True)):
        x = first + lane * frame.sheet.track
        runs, heads = _ends(frame, column, number, x, x)
        rows = turn.lefts + turn.rights
        yield Wire(net, (*runs, Run(x, min(rows), x, max(rows))), tuple(heads))


def _carried(frame: Frame, column: int, gap: Gap) -> Iterator[Wire]:
    """Yield the lines from the end of a row to the next one.

    The uppermost turns last, runs lowest and turns first again, as threads of a screw do, so
    that lines cross only where their order changes.
    """
    track, count = frame.sheet.track, len(gap.nets)
    order = sorted(range(count), key=lambda number: min(gap.turns[number].lefts))
    for at, number in enumerate(order):
        turn = gap.turns[number]
        down = _edge(frame, column) + BEHIND + (count - 1 - at) * track
        channel = frame.channels[column] + count - 1 - at
        back = frame.indent - BEFORE - 1 - at * track
        runs, heads = _ends(frame, column, number, down, back)
        runs += [
            Run(down, min(turn.lefts), down, channel),
            Run(back, channel, down, channel),
            Run(back, channel, back, max(turn.rights)),
        ]
        yield Wire(gap.nets[number], tuple(runs), tuple(heads))


def _edge(frame: Frame, column: int) -> int:
    return frame.starts[column] + frame.sheet.widths[column]


def _ends(
    frame: Frame, column: int, number: int, first: int, last: int
) -> tuple[list[Run], list[Head]]:
    """Return the level runs between what a net joins and its lanes, and the arrow heads there.

    The lane on the left is at `first`, that on the right at `last`: mostly they are the same.
    """
    gap = frame.gaps[column]
    net, turn, (lefts, rights) = gap.nets[number], gap.turns[number], gap.items[number]
    runs, heads = [], []
    for item, row in zip(lefts, turn.lefts, strict=True):
        place = frame.places.get(item)
        x = _edge(frame, column) if place is None else place.x + place.width
        runs.append(Run(x, row, first, row))
        if place is not None and net.is_backward:
            heads.append(Head(x, row, to_right=False))
    for item, row in zip(rights, turn.rights, strict=True):
        place = frame.places.get(item)
        x = frame.starts[column + 1] if place is None else place.x
        runs.append(Run(last, row, x - 1, row))
        if place is not None and not net.is_backward:
            heads.append(Head(x - 1, row, to_right=True))
    return runs, heads
