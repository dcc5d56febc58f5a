"""From where a robot is looked at, without perspective.

The three views stand as in a drawing in third-angle projection (ISO 128): the robot from its right
side, with its front (x) to the right and up (z) above; over it the view from above; right of it
the view from the front. So what is beside or above each other has the same x or z. Axes are those
of ROS: x ahead, y to the left, z up (REP 103).
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from plastron_tui.ros.robots.description import Vector


class Point(NamedTuple):
    """A place in a view, in metres: to the right, and up."""

    x: float
    y: float


class View(NamedTuple):
    """A direction to look in.

    Attributes:
        key: a word for it.
        name: what the view is called.
        right: what points to the right.
        up: what points up.
        near: what points at who looks.
        axes: what `right` and `up` are called.
    """

    key: str
    name: str
    right: Vector
    up: Vector
    near: Vector
    axes: tuple[str, str]

    def point(self, at: Vector) -> Point:
        """Return where a point is seen, or a direction."""
        return Point(dot(self.right, at), dot(self.up, at))

    def depth(self, at: Vector) -> float:
        """Return how near a point is, more is nearer."""
        return dot(self.near, at)


_X, _Y, _Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)

TOP = View("top", "top", _X, _Y, _Z, ("x", "y"))
SIDE = View("side", "right side", _X, _Z, (0.0, -1.0, 0.0), ("x", "z"))
FRONT = View("front", "front", _Y, _Z, _X, ("y", "z"))

VIEWS = (TOP, SIDE, FRONT)
"""All of them."""


class Frame(NamedTuple):
    """A rectangle that something fits into."""

    left: float
    low: float
    right: float
    high: float

    @property
    def width(self) -> float:
        """From side to side."""
        return self.right - self.left

    @property
    def height(self) -> float:
        """From bottom to top."""
        return self.high - self.low


def dot(one: Vector, other: Vector) -> float:
    """Return the scalar product."""
    return one[0] * other[0] + one[1] * other[1] + one[2] * other[2]


def cross(one: Vector, other: Vector) -> Vector:
    """Return the vector product."""
    return (
        one[1] * other[2] - one[2] * other[1],
        one[2] * other[0] - one[0] * other[2],
        one[0] * other[1] - one[1] * other[0],
    )


def hull(points: Iterable[Point]) -> tuple[Point, ...]:
    """Return the corners of the convex hull, to the left around it (Andrew's monotone chain)."""
    ordered = sorted(set(points))
    if len(ordered) < 3:
        return tuple(ordered)
    lower, upper = _chain(ordered), _chain(reversed(ordered))
    return (*lower[:-1], *upper[:-1])


def _chain(points: Iterable[Point]) -> list[Point]:
    chain: list[Point] = []
    for point in points:
        while len(chain) > 1 and _turn(chain[-2], chain[-1], point) <= 0:
            chain.pop()
        chain.append(point)
    return chain


def _turn(one: Point, other: Point, third: Point) -> float:
    return (other.x - one.x) * (third.y - one.y) - (other.y - one.y) * (third.x - one.x)
