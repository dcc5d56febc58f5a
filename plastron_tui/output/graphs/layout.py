"""Where everything in a picture goes: boxes in columns, curves in the gaps between them.

A curve lies in the gap between two columns and is level at both ends; across a column a line
runs level, in a lane of its own. So no line runs through a box. Lengths are in pixels, y grows
downward.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import sqrt

from .boxes import LANE, PAIR, STUB, Box, Point, Ports, Shape, is_pair
from .coordinates import placed
from .layers import Columns, Link, columns_of, components
from .ordering import ordered

_NARROWEST_GAP = 46.0
_WIDEST_GAP = 280.0
_BETWEEN = 36.0


@dataclass(frozen=True, slots=True)
class Layout:
    """A picture's size, its boxes, and its lines, each by its link.

    A line is its points from the tail to the head: level pieces and curves take turns, a level
    piece first and last. A link to a service has two: the request, which runs from tail to
    head, and the response, which runs back and starts at the head.
    """

    width: float
    height: float
    boxes: tuple[Box, ...]
    lines: dict[Link, tuple[tuple[Point, ...], ...]]


def layout(boxes: Sequence[Box], links: Sequence[Link]) -> Layout:
    """Place the boxes and draw the links, a group that hangs together next to the other."""
    links = list(dict.fromkeys(links))
    hubs = frozenset(at for at, box in enumerate(boxes) if box.shape is not Shape.NODE)
    parts = components(len(boxes), links)
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


class _Part:
    """One group of boxes that hang together."""

    def __init__(self, boxes: dict[int, Box], links: list[Link], hubs: frozenset[int]) -> None:
        self._boxes = boxes
        self._hubs = hubs
        self._columns: Columns = columns_of(list(boxes), links, hubs)

    def drawn(self) -> _Drawn:
        """Return the group, its upper left corner at the origin."""
        self._grow_nodes()
        order = ordered(self._columns)
        heights = {box: placing.height for box, placing in self._boxes.items()}
        for link, route in self._columns.routes.items():
            height = 2 * PAIR if is_pair(self._boxes, link) else 0.0
            heights.update((item, height) for item in route if item < 0)
        middles = placed(self._columns, order, heights, {})
        # The first try says where lines leave their boxes, the second makes them straighter.
        ports = Ports(self._boxes, self._columns, self._hubs, middles)
        middles = placed(self._columns, order, heights, ports.by_neighbour())
        top = min(middles[item] - heights[item] / 2 for item in middles)
        middles = {item: at - top for item, at in middles.items()}
        spans = self._column_spans(order, middles)
        for box, placing in self._boxes.items():
            left, right = spans[self._columns.column_of[box]]
            self._boxes[box] = replace(
                placing,
                x=(left + right - placing.width) / 2,
                y=middles[box] - placing.height / 2,
            )
        ports = Ports(self._boxes, self._columns, self._hubs, middles)
        lines = {
            link: self._lines(link, route, ports, middles, spans)
            for link, route in self._columns.routes.items()
        }
        height = max(middles[item] + heights[item] / 2 for item in middles)
        return _Drawn(spans[-1][1], height, self._boxes, lines)

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

    def _column_spans(
        self, order: list[list[int]], middles: dict[int, float]
    ) -> list[tuple[float, float]]:
        """Return from where to where each column reaches; steep gaps are wider."""
        rise = [0.0] * len(order)
        for one, other in self._columns.segments:
            column = self._columns.column_of[one]
            rise[column] = max(rise[column], abs(middles[one] - middles[other]))
        spans = []
        left = 0.0
        for column, items in enumerate(order):
            width = max((self._boxes[item].width for item in items if item >= 0), default=0.0)
            spans.append((left, left + width))
            gap = _NARROWEST_GAP + 0.22 * rise[column]
            left += width + min(gap, _WIDEST_GAP) + 2 * STUB
        return spans

    def _lines(
        self,
        link: Link,
        route: list[int],
        ports: Ports,
        middles: dict[int, float],
        spans: list[tuple[float, float]],
    ) -> tuple[tuple[Point, ...], ...]:
        """Return the line of a link to a topic, the two of a link to a service."""
        is_backward = link in self._columns.reversed

        def line(shift: float) -> tuple[Point, ...]:
            return self._line(link, route, ports, middles, spans, shift)

        if not is_pair(self._boxes, link):
            points = line(0.0)
            return (points[::-1] if is_backward else points,)
        upper, lower = line(-PAIR), line(PAIR)
        return (upper[::-1], lower) if is_backward else (upper, lower[::-1])

    def _line(
        self,
        link: Link,
        route: list[int],
        ports: Ports,
        middles: dict[int, float],
        spans: list[tuple[float, float]],
        shift: float,
    ) -> tuple[Point, ...]:
        """Return a line's points from left to right, `shift` off the middle of its lane."""
        points = []
        for place, item in enumerate(route):
            left, right = spans[self._columns.column_of[item]]
            if item < 0:
                y = middles[item] + shift
                points += [Point(left - STUB, y), Point(right + STUB, y)]
                continue
            box = self._boxes[item]
            is_left = place > 0
            dy = ports.offset(link, item, is_left=is_left) + shift
            y = box.middle + dy
            if is_left:
                points += [Point(left - STUB, y), Point(box.x + box.inset(dy), y)]
            else:
                points += [Point(box.x + box.width - box.inset(dy), y), Point(right + STUB, y)]
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
