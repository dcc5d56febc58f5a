"""What bodies look like from one side: outlines, and the faces in them that one sees."""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache
from itertools import product
from math import atan2, cos, hypot, pi, sin
from typing import NamedTuple

from plastron_tui.ros.robots.description import Box, Cylinder, Sphere, Vector
from plastron_tui.ros.robots.transforms import Transform

from .solids import Hull, Solid
from .views import Frame, Point, View, cross, dot, hull

CORNERS = 32
"""How many corners stand for a circle that is seen at an angle: its area is 0.7 % too small."""

_EDGE_ON = 1e-6
"""A face that shows less than this of itself is not seen."""


class Face(NamedTuple):
    """A flat face, and how far it is turned to who looks: 1 is straight on, 0 edge-on."""

    points: tuple[Point, ...]
    facing: float


class Ellipse(NamedTuple):
    """The rim of a cylinder, seen at an angle.

    Attributes:
        long: half its length.
        short: half its width.
        turn: how far its length is turned from the right to the left, in radians.
    """

    long: float
    short: float
    turn: float


class Outline(NamedTuple):
    """What one sees of a body.

    Attributes:
        solid: the body.
        points: the corners of its outline, to the left around it; one for a body of which nobody
            knows how large it is.
        radius: that of the circle around the only point, 0 for none.
        faces: the flat faces that one sees, where that is more than one, or less than all.
        facing: how far what is not a face of these is turned to who looks.
        nearest: how near its nearest point is.
        rim: what the rounded parts of the outline are, None for one without. The first half of the
            points is on one of them, the other half on another one.
    """

    solid: Solid
    points: tuple[Point, ...]
    radius: float
    faces: tuple[Face, ...]
    facing: float
    nearest: float
    rim: Ellipse | None = None

    @property
    def frame(self) -> Frame:
        """What it fits into."""
        frame = frame_of(self.points)
        return Frame(
            frame.left - self.radius,
            frame.low - self.radius,
            frame.right + self.radius,
            frame.high + self.radius,
        )


def outline(solid: Solid, view: View, corners: int = CORNERS) -> Outline:
    """Return what one sees of a body from one side; an even number of corners is a circle."""
    at = solid.at
    match solid.shape:
        case Box(size=size):
            return _box(solid, size, view)
        case Cylinder(radius=radius, length=length):
            return _cylinder(solid, radius, length, view, corners)
        case Sphere(radius=radius):
            middle = at.translation
            nearest = view.depth(middle) + radius
            return Outline(solid, (view.point(middle),), radius, (), 1.0, nearest)
        case Hull(points=points):
            placed = [at.point(point) for point in points]
            nearest = max(map(view.depth, placed))
            return Outline(solid, hull(map(view.point, placed)), 0.0, (), 1.0, nearest)
        case None:
            middle = at.translation
            return Outline(solid, (view.point(middle),), 0.0, (), 1.0, view.depth(middle))


def frame_of(points: Iterable[Point]) -> Frame:
    """Return the rectangle that points fit into."""
    xs, ys = zip(*points, strict=True)
    return Frame(min(xs), min(ys), max(xs), max(ys))


def _box(solid: Solid, size: Vector, view: View) -> Outline:
    at = solid.at
    half = [length / 2 for length in size]
    corners = [
        at.point((a * half[0], b * half[1], c * half[2]))
        for a, b, c in product((-1.0, 1.0), repeat=3)
    ]
    nearest = max(map(view.depth, corners))
    seen = tuple(map(view.point, corners))
    faces = []
    for axis in range(3):
        facing = _facing(at, axis, view)
        side = 1 if facing > 0 else 0
        if abs(facing) > _EDGE_ON:
            faces.append(Face(tuple([seen[number] for number in _FACES[axis, side]]), abs(facing)))
    if len(faces) == 1:
        return Outline(solid, hull(faces[0].points), 0.0, (), faces[0].facing, nearest)
    points = hull(seen)
    return Outline(solid, points, 0.0, tuple(faces), 1.0, nearest)


# A corner's number has a bit for each axis, x the highest.
_FACES = {
    (0, 0): (0, 1, 3, 2),
    (0, 1): (4, 5, 7, 6),
    (1, 0): (0, 1, 5, 4),
    (1, 1): (2, 3, 7, 6),
    (2, 0): (0, 2, 6, 4),
    (2, 1): (1, 3, 7, 5),
}


def _facing(at: Transform, axis: int, view: View) -> float:
    """Return how far an axis of a body points at who looks."""
    x, y, z = (at.rotation[row][axis] for row in range(3))
    return dot(view.near, (x, y, z))


def _cylinder(solid: Solid, radius: float, length: float, view: View, corners: int) -> Outline:
    at = solid.at
    along = at.direction((0.0, 0.0, 1.0))
    facing = dot(view.near, along)
    middle = at.translation
    across = cross(along, view.near)
    size = hypot(*across)
    # How near the rim comes to who looks, seen from the middle of its end.
    nearest = view.depth(middle) + abs(facing) * length / 2 + radius * size
    if size < _EDGE_ON:
        return Outline(solid, (view.point(middle),), radius, (), 1.0, nearest)
    # The first of these is where the outline is farthest from the axis; the second one is seen
    # where the axis points, so that the rim goes to the left around.
    first: Vector = (across[0] / size, across[1] / size, across[2] / size)
    second = cross(along, first) if facing >= 0 else cross(first, along)
    one, other = view.point(first), view.point(second)
    rim = [
        Point(radius * (a * one.x + b * other.x), radius * (a * one.y + b * other.y))
        for a, b in _circle(corners)
    ]
    center, end = view.point(middle), view.point(along)
    half = length / 2
    # The first half of the rim bulges to where the axis points: the end there has it in the
    # outline, and the other end its second half.
    upper, lower = (
        [Point(center.x + sign * end.x + p.x, center.y + sign * end.y + p.y) for p in rim]
        for sign in (half, -half)
    )
    count = corners // 2
    points = (*upper[: count + 1], *lower[count:], lower[0])
    cap = (
        (Face(tuple(upper if facing > 0 else lower), abs(facing)),)
        if abs(facing) > _EDGE_ON
        else ()
    )
    rim_shape = Ellipse(radius, radius * abs(facing), atan2(one.y, one.x))
    return Outline(solid, points, 0.0, cap, size, nearest, rim_shape)


@lru_cache(maxsize=4)
def _circle(corners: int) -> tuple[tuple[float, float], ...]:
    steps = [2 * pi * at / corners for at in range(corners)]
    return tuple((cos(step), sin(step)) for step in steps)
