"""Where everything in a picture goes: boxes in columns, curves in the gaps between them.

A curve lies in the gap between two columns and is level at both ends; across a column a line
runs level, in a lane of its own. So no line runs through a box. A long picture has its columns
in several rows, as a paragraph has its words; what leads from one to the next runs around them,
in lanes as well. Lengths are in pixels, y grows downward.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from math import log, sqrt
from typing import NamedTuple

from .boxes import LANE, PAIR, STUB, Box, Point, Ports, Shape, is_pair
from .breaks import Strip, breaks_of, rows_between
from .coordinates import placed
from .layers import Columns, Link, Net, columns_of, components, nets_between
from .ordering import neighbours_of, ordered

_NARROWEST_GAP = 46.0
_WIDEST_GAP = 280.0
_BETWEEN = 36.0

_SHAPE = 1.6
"""How much wider than high a picture should be."""
_WIDEST, _WIDEST_SHAPE = 1600.0, 2.4
"""A picture that is wider than both, in pixels and against its height, is broken into rows."""
_NARROWER, _LEAST_WIDTH = 0.85, 600.0
"""Rows are tried that are so much shorter each time, down to some pixels."""
_MOST_CARRIED = 8
_CARRIED_COST = 0.06
"""What a line that leads to another row costs, beside the logarithm of a shape's error."""
_AROUND_CHANNEL = 18.0
"""How far the lines from one row to the next are from both."""


@dataclass(frozen=True, slots=True)
class Layout:
    """A picture's size, its boxes, and its lines, each by its link.

    A line is its points from the tail to the head. Between two points it is level or upright if
    they are, and else a curve that is level at both ends. A link to a service has two: the
    request, which runs from tail to head, and the response, which runs back and starts at the
    head.
    """

    width: float
    height: float
    boxes: tuple[Box, ...]
    lines: dict[Link, tuple[tuple[Point, ...], ...]]


def layout(boxes: Sequence[Box], links: Sequence[Link]) -> Layout:
    """Place the boxes and draw the links, a group that hangs together next to the other."""
    links = list(dict.fromkeys(links))
    hubs = frozenset(at for at, box in enumerate(boxes) if box.shape is not Shape.NODE)
    parts = components(range(len(boxes)), links)
    part_of = {box: at for at, part in enumerate(parts) for box in part}
    links_of: list[list[Link]] = [[] for _ in parts]
    for link in links:
        links_of[part_of[link.tail]].append(link)
    return _packed(
        len(boxes),
        [
            _Part(dict(zip(part, (boxes[at] for at in part), strict=True)), own, hubs).drawn()
            for part, own in zip(parts, links_of, strict=True)
        ],
    )


@dataclass(frozen=True, slots=True)
class _Drawn:
    width: float
    height: float
    boxes: dict[int, Box]
    lines: dict[Link, tuple[tuple[Point, ...], ...]]


class _Carry(NamedTuple):
    """How a net gets to the next row: down at an x, back at a y, and on at another x."""

    down: float
    channel: float
    back: float


class _Part:
    """One group of boxes that hang together, in as many rows as make it a picture of good shape."""

    def __init__(self, boxes: dict[int, Box], links: list[Link], hubs: frozenset[int]) -> None:
        self._boxes = boxes
        self._columns: Columns = columns_of(list(boxes), links, hubs)
        self._grow_nodes()
        self._order = ordered(self._columns)
        self._heights = {box: placing.height for box, placing in boxes.items()}
        for link, route in self._columns.routes.items():
            height = 2 * PAIR if is_pair(boxes, link) else 0.0
            self._heights.update((item, height) for item in route if item < 0)
        self._lanes = {net: LANE[is_pair(boxes, link)] for link, net in self._columns.nets.items()}
        self._between = nets_between(self._columns)
        self._place(())

    def drawn(self) -> _Drawn:
        """Return the group, its upper left corner at the origin."""
        if self._width > _WIDEST and self._width > _WIDEST_SHAPE * self._height:
            self._place(self._best_cuts())
        for box, placing in self._boxes.items():
            left, right = self._spans[self._columns.column_of[box]]
            self._boxes[box] = replace(
                placing,
                x=(left + right - placing.width) / 2,
                y=self._middles[box] - placing.height / 2,
            )
        carries = {column: self._carries(column) for column in self._cuts}
        lines = {
            link: self._lines(link, route, carries) for link, route in self._columns.routes.items()
        }
        return _Drawn(self._width, self._height, self._boxes, lines)

    def _grow_nodes(self) -> None:
        """Make nodes as high as the lines at their sides need."""
        needed: dict[tuple[int, bool], float] = {}
        for link, route in self._columns.routes.items():
            lane = LANE[is_pair(self._boxes, link)]
            for end, is_left in ((route[0], False), (route[-1], True)):
                needed[end, is_left] = needed.get((end, is_left), 0.0) + lane
        for (box, _), lanes in needed.items():
            placing = self._boxes[box]
            if placing.shape is Shape.NODE and placing.height < lanes + 16:
                self._boxes[box] = replace(placing, height=lanes + 16)

    def _best_cuts(self) -> tuple[int, ...]:
        """Return the columns that end a row so that the picture has about the wanted shape."""
        widths = [right - left for left, right in self._spans]
        gaps = [after[0] - before[1] for before, after in pairwise(self._spans)]
        carried = [len(nets) for nets in self._between]
        strip = Strip(widths, gaps, carried, max(self._lanes.values()), 4 * STUB)
        whole = self._width
        shapes: dict[tuple[int, ...], float] = {(): abs(log(whole / self._height / _SHAPE))}
        room = whole
        while room > max(_LEAST_WIDTH, max(widths)):
            room *= _NARROWER
            cuts = breaks_of(strip, room, _MOST_CARRIED)
            if cuts:
                lines = sum(strip.carried[cut] for cut in cuts)
                shapes[cuts] = self._shape_error(strip, cuts) + _CARRIED_COST * lines
        return min(shapes, key=shapes.__getitem__)

    def _shape_error(self, strip: Strip, cuts: tuple[int, ...]) -> float:
        """Return how far the picture would be from the wanted shape, on a scale of its own."""
        width = height = 0.0
        for row in rows_between(cuts, len(self._order)):
            width = max(width, self._spans[row[-1]][1] - self._spans[row[0]][0])
            items = [item for column in row for item in self._order[column]]
            height += max(self._middles[item] + self._heights[item] / 2 for item in items)
            height -= min(self._middles[item] - self._heights[item] / 2 for item in items)
        height += sum(strip.lane * strip.carried[cut] + 2 * _AROUND_CHANNEL for cut in cuts)
        return abs(log(width / height / _SHAPE))

    def _place(self, cuts: tuple[int, ...]) -> None:
        """Set where everything is, with the columns in rows of which all but the last end so."""
        self._cuts = frozenset(cuts)
        self._rows = rows_between(cuts, len(self._order))
        neighbours = neighbours_of(self._columns, self._cuts)
        middles = placed(neighbours, self._order, self._heights, {})
        # The first try says where lines leave their boxes, the second makes them straighter.
        ports = Ports(self._columns, middles, self._lanes.__getitem__)
        middles = placed(neighbours, self._order, self._heights, ports.by_neighbour())
        self._ports = Ports(self._columns, middles, self._lanes.__getitem__)
        self._stack(middles)
        self._place_columns()

    def _stack(self, middles: dict[int, float]) -> None:
        """Put the rows below each other, with room for the lines that lead from one to the next."""
        self._middles: dict[int, float] = {}
        self._channels: dict[int, float] = {}
        top = 0.0
        for row in self._rows:
            items = [item for column in row for item in self._order[column]]
            shift = top - min(middles[item] - self._heights[item] / 2 for item in items)
            self._middles.update((item, middles[item] + shift) for item in items)
            top = max(self._middles[item] + self._heights[item] / 2 for item in items)
            if row[-1] in self._cuts:
                top += _AROUND_CHANNEL
                self._channels[row[-1]] = top
                top += self._carried_width(row[-1]) + _AROUND_CHANNEL
        self._height = top

    def _carried_width(self, column: int) -> float:
        return sum(self._lanes[net] for net in self._between[column])

    def _place_columns(self) -> None:
        """Set from where to where each column reaches; steep gaps are wider."""
        rise = [0.0] * len(self._order)
        for one, other in self._columns.segments:
            column = self._columns.column_of[one]
            if column not in self._cuts:
                apart = abs(self._middles[one] - self._middles[other])
                rise[column] = max(rise[column], apart)
        self._indent = 0.0
        if self._cuts:
            self._indent = max(map(self._carried_width, self._cuts)) + 2 * STUB
        self._spans: list[tuple[float, float]] = []
        self._width = 0.0
        for row in self._rows:
            left = self._indent
            for column in row:
                items = self._order[column]
                width = max((self._boxes[item].width for item in items if item >= 0), default=0.0)
                self._spans.append((left, left + width))
                gap = _NARROWEST_GAP + 0.22 * rise[column]
                left += width + min(gap, _WIDEST_GAP) + 2 * STUB
            right = self._spans[row[-1]][1]
            if row[-1] in self._cuts:
                right += 2 * STUB + self._carried_width(row[-1])
            self._width = max(self._width, right)

    def _carries(self, column: int) -> dict[Net, _Carry]:
        """Return how each net gets from the end of a row to the next one.

        The uppermost turns last, runs lowest and turns first again, as threads of a screw do, so
        that lines cross only where their order changes.
        """
        between = self._between[column]

        def height(net: Net) -> float:
            lefts, _ = between[net]
            return min(self._port(net, item, is_left=False) for item in lefts)

        carries = {}
        total = self._carried_width(column)
        right = self._spans[column][1] + 2 * STUB
        done = 0.0
        for net in sorted(between, key=height):
            lane = self._lanes[net]
            done += lane
            carries[net] = _Carry(
                right + total - done + lane / 2,
                self._channels[column] + total - done + lane / 2,
                self._indent - 2 * STUB - done + lane / 2,
            )
        return carries

    def _port(self, net: Net, item: int, *, is_left: bool) -> float:
        """Return the y at which a net reaches a box or a turning point."""
        off = 0.0 if item < 0 else self._ports.offset(net, item, is_left=is_left)
        return self._middles[item] + off

    def _lines(
        self, link: Link, route: list[int], carries: Mapping[int, Mapping[Net, _Carry]]
    ) -> tuple[tuple[Point, ...], ...]:
        """Return the line of a link to a topic, the two of a link to a service."""
        is_backward = link in self._columns.reversed
        if not is_pair(self._boxes, link):
            points = self._line(link, route, carries, 0.0)
            return (points[::-1] if is_backward else points,)
        upper, lower = (self._line(link, route, carries, shift) for shift in (-PAIR, PAIR))
        return (upper[::-1], lower) if is_backward else (upper, lower[::-1])

    def _line(
        self,
        link: Link,
        route: list[int],
        carries: Mapping[int, Mapping[Net, _Carry]],
        shift: float,
    ) -> tuple[Point, ...]:
        """Return a line's points from its left end on, `shift` off the middle of its lane."""
        net = self._columns.nets[link]
        points = []
        for place, item in enumerate(route):
            column = self._columns.column_of[item]
            left, right = self._spans[column]
            if place > 0:
                y = self._port(net, item, is_left=True) + shift
                carry = carries.get(column - 1)
                points.append(Point(left - STUB if carry is None else carry[net].back - shift, y))
                if item >= 0:
                    box = self._boxes[item]
                    points.append(Point(box.x + box.inset(y - box.middle), y))
            if place < len(route) - 1:
                y = self._port(net, item, is_left=False) + shift
                if item >= 0:
                    box = self._boxes[item]
                    points.append(Point(box.x + box.width - box.inset(y - box.middle), y))
                carry = carries.get(column)
                if carry is None:
                    points.append(Point(right + STUB, y))
                    continue
                down, channel, back = carry[net]
                points += [
                    Point(down - shift, y),
                    Point(down - shift, channel - shift),
                    Point(back - shift, channel - shift),
                ]
        return tuple(points)


def _packed(count: int, parts: list[_Drawn]) -> Layout:
    """Put the groups in rows, the largest first, so that the picture is wider than high."""
    area = sum((part.width + _BETWEEN) * (part.height + _BETWEEN) for part in parts)
    room = max([sqrt(area * 1.9), *(part.width for part in parts)], default=0.0)
    boxes: dict[int, Box] = {}
    lines: dict[Link, tuple[tuple[Point, ...], ...]] = {}
    x = y = row = width = 0.0
    for part in sorted(parts, key=lambda part: -part.height):
        if x > 0 and x + part.width > room:
            x, y, row = 0.0, y + row + _BETWEEN, 0.0
        for number, box in part.boxes.items():
            boxes[number] = replace(box, x=box.x + x, y=box.y + y)
        for link, drawn in part.lines.items():
            lines[link] = tuple(
                tuple(Point(point.x + x, point.y + y) for point in line) for line in drawn
            )
        width = max(width, x + part.width)
        row = max(row, part.height)
        x += part.width + _BETWEEN
    return Layout(width, y + row, tuple(boxes[number] for number in range(count)), lines)
