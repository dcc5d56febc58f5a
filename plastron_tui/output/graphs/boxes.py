"""The boxes of a picture, their outlines, and the places where lines reach them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from enum import Enum
from math import sqrt
from typing import NamedTuple

from .layers import Columns, Link

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


_Slot = tuple[int, bool, Link | bool]


class Ports:
    """Where lines reach their boxes: in the order of what they lead to, so that none cross there.

    At a node each line has a port of its own; at a topic, service or action all lines of one
    direction share one.
    """

    def __init__(
        self,
        boxes: Mapping[int, Box],
        columns: Columns,
        hubs: frozenset[int],
        middles: Mapping[int, float],
    ) -> None:
        self._columns = columns
        self._hubs = hubs
        self._offsets: dict[_Slot, float] = {}
        sides: dict[tuple[int, bool], dict[_Slot, list[float]]] = {}
        lanes: dict[_Slot, float] = {}
        for link, end, near, is_left in self._ends():
            slot = self._slot(link, end, is_left=is_left)
            sides.setdefault((end, is_left), {}).setdefault(slot, []).append(middles[near])
            lanes[slot] = LANE[is_pair(boxes, link)]
        for slots in sides.values():
            mean = {slot: sum(places) / len(places) for slot, places in slots.items()}
            at = -sum(lanes[slot] for slot in slots) / 2
            for slot in sorted(slots, key=mean.__getitem__):
                self._offsets[slot] = at + lanes[slot] / 2
                at += lanes[slot]

    def offset(self, link: Link, end: int, *, is_left: bool) -> float:
        """Return how far off its box's middle a link's port is, on the one side or the other."""
        return self._offsets[self._slot(link, end, is_left=is_left)]

    def by_neighbour(self) -> dict[tuple[int, int], float]:
        """Return the offset for each box and what it is joined with next."""
        return {
            (end, near): self.offset(link, end, is_left=is_left)
            for link, end, near, is_left in self._ends()
        }

    def _ends(self) -> Iterator[tuple[Link, int, int, bool]]:
        """Yield each end of each link: the box, what comes next, whether at the box's left."""
        for link, route in self._columns.routes.items():
            yield link, route[0], route[1], False
            yield link, route[-1], route[-2], True

    def _slot(self, link: Link, end: int, *, is_left: bool) -> _Slot:
        return (end, is_left, link.tail == end if end in self._hubs else link)
