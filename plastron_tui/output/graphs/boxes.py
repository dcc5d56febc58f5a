"""The boxes of a picture, their outlines, and the places where lines reach them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from enum import Enum
from math import sqrt
from typing import NamedTuple

from .layers import Columns, Link, Net

PAIR = 4.5
"""How far the request and the response of a call run from the middle of their lane."""
STUB = 12.0
"""The least length of the level piece at the end of a line, which the arrow head needs."""
CUT = 14.0
"""How far the points of a service's hexagon stand out."""
BEVEL = 9.0
"""How much of each side the corners of an action's octagon take."""

LANE = {False: 13.0, True: 21.0}
"""How much of a box's side a line takes, and a pair of lines."""


class Shape(Enum):
    """What a box stands for, and so its outline."""

    NODE = "node"
    TOPIC = "topic"
    SERVICE = "service"
    ACTION = "action"


class Point(NamedTuple):
    """A place in the picture."""

    x: float
    y: float


@dataclass(frozen=True, slots=True)
class Box:
    """A box to place, and then its place: `x` and `y` are its upper left corner."""

    shape: Shape
    width: float
    height: float
    x: float = 0.0
    y: float = 0.0

    @property
    def middle(self) -> float:
        """The y of the box's middle."""
        return self.y + self.height / 2

    def inset(self, dy: float) -> float:
        """Return how far the outline lies inside of the box's side, `dy` off its middle."""
        return inset(self.shape, self.height, dy)


def inset(shape: Shape, height: float, dy: float) -> float:
    """Return how far an outline of some height lies inside of its side, `dy` off the middle."""
    half = height / 2
    if shape is Shape.NODE:
        return 0.0
    if shape is Shape.SERVICE:
        return CUT * min(abs(dy) / half, 1.0)
    if shape is Shape.ACTION:
        return min(max(abs(dy) - half + BEVEL, 0.0), BEVEL)
    return half - sqrt(max(half * half - dy * dy, 0.0))


def is_pair(boxes: Mapping[int, Box], link: Link) -> bool:
    """Tell whether a link is drawn as two lines: a request and its response."""
    shapes = {boxes[link.tail].shape, boxes[link.head].shape}
    return not shapes.isdisjoint((Shape.SERVICE, Shape.ACTION))


class Ports:
    """Where lines reach their boxes: in the order of what they lead to, so that none cross there.

    Each net has a port of its own at each box: at a node that is one for each link, at a topic,
    service or action all links of one direction share one.
    """

    def __init__(
        self, columns: Columns, middles: Mapping[int, float], lane_of: Callable[[Net], float]
    ) -> None:
        """Place the ports, each in the middle of a lane.

        Args:
            columns: the boxes, and the links.
            middles: where boxes and turning points are.
            lane_of: how much of a box's side the lines of a net take.
        """
        self._columns = columns
        self._offsets: dict[tuple[int, bool, Net], float] = {}
        sides: dict[tuple[int, bool], dict[Net, list[float]]] = {}
        for net, end, near, is_left in self._ends():
            sides.setdefault((end, is_left), {}).setdefault(net, []).append(middles[near])
        for (end, is_left), nets in sides.items():
            mean = {net: sum(places) / len(places) for net, places in nets.items()}
            lanes = {net: lane_of(net) for net in nets}
            at = -sum(lanes.values()) / 2
            for net in sorted(nets, key=mean.__getitem__):
                self._offsets[end, is_left, net] = at + lanes[net] / 2
                at += lanes[net]

    def offset(self, net: Net, end: int, *, is_left: bool) -> float:
        """Return how far off its box's middle a net's port is, on the one side or the other."""
        return self._offsets[end, is_left, net]

    def by_neighbour(self) -> dict[tuple[int, int], float]:
        """Return the offset for each box and what it is joined with next."""
        return {
            (end, near): self._offsets[end, is_left, net]
            for net, end, near, is_left in self._ends()
        }

    def _ends(self) -> Iterator[tuple[Net, int, int, bool]]:
        """Yield each end of each link: the box, what comes next, whether at the box's left."""
        for link, route in self._columns.routes.items():
            net = self._columns.nets[link]
            yield net, route[0], route[1], False
            yield net, route[-1], route[-2], True
