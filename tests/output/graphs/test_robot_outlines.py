"""What bodies look like from one side, held against what one knows of their shapes."""

from __future__ import annotations

from math import cos, hypot, pi, sin

import pytest
from drawn_robots import poses, shapes
from hypothesis import given, settings
from machine import examples

from plastron_tui.output.graphs.robots.outlines import Outline, frame_of, outline
from plastron_tui.output.graphs.robots.polygons import stretches
from plastron_tui.output.graphs.robots.scales import ruler_length, ruler_text
from plastron_tui.output.graphs.robots.solids import Solid
from plastron_tui.output.graphs.robots.views import VIEWS, Point, View, cross, dot, hull
from plastron_tui.ros.robots.description import Box, Cylinder, Pose, Shape, Sphere, Vector
from plastron_tui.ros.robots.transforms import Transform

_CLOSE = 1e-6


def reach(shape: Shape, at: Transform, along: Vector) -> float:
    """Return how far a body reaches in a direction: the support function of its shape."""
    middle = dot(at.translation, along)
    axes = [at.direction(axis) for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
    match shape:
        case Box(size=size):
            parts = (
                length / 2 * abs(dot(axis, along)) for length, axis in zip(size, axes, strict=True)
            )
            return middle + sum(parts)
        case Cylinder(radius=radius, length=length):
            return (
                middle
                + length / 2 * abs(dot(axes[2], along))
                + radius * hypot(dot(axes[0], along), dot(axes[1], along))
            )
        case Sphere(radius=radius):
            return middle + radius
    raise AssertionError(shape)


def outline_reach(seen: Outline, across: float, up: float) -> float:
    return max(across * x + up * y for x, y in seen.points) + seen.radius


@settings(max_examples=examples(120), deadline=None)
@given(shapes, poses)
def test_outlines_reach_as_far_as_bodies(shape: Shape, pose: Pose) -> None:
    at = Transform().then(pose)
    for view in VIEWS:
        seen = outline(Solid("a", shape, at), view)
        for step in range(24):
            across, up = cos(step * pi / 12), sin(step * pi / 12)
            x, y, z = (across * a + up * b for a, b in zip(view.right, view.up, strict=True))
            wanted = reach(shape, at, (x, y, z))
            # 32 corners stand for a rim: between them it reaches 0.5 % of the radius farther.
            slack = 0.005 * shape.radius if isinstance(shape, Cylinder) else _CLOSE
            assert wanted - slack - _CLOSE <= outline_reach(seen, across, up) <= wanted + _CLOSE
        assert seen.nearest == pytest.approx(reach(shape, at, view.near), abs=_CLOSE)


@settings(max_examples=examples(120), deadline=None)
@given(shapes, poses)
def test_outlines_are_convex_and_go_to_the_left_around(shape: Shape, pose: Pose) -> None:
    for view in VIEWS:
        seen = outline(Solid("a", shape, Transform().then(pose)), view)
        if seen.radius:
            assert len(seen.points) == 1
            continue
        assert len(seen.points) > 3
        for at, point in enumerate(seen.points):
            before, last = seen.points[at - 1], seen.points[at - 2]
            turn = (before.x - last.x) * (point.y - before.y) - (before.y - last.y) * (
                point.x - before.x
            )
            assert turn > -_CLOSE
        for face in seen.faces:
            assert 0 < face.facing < 1 + _CLOSE
            frame, whole = frame_of(face.points), seen.frame
            assert whole.left - _CLOSE <= frame.left and frame.right <= whole.right + _CLOSE
            assert whole.low - _CLOSE <= frame.low and frame.high <= whole.high + _CLOSE


def test_the_faces_of_a_turned_box_are_all_of_its_outline() -> None:
    at = Transform().then(Pose((0.1, 0.2, 0.3), (0.4, 0.5, 0.6)))
    for view in VIEWS:
        seen = outline(Solid("a", Box((1, 2, 3)), at), view)
        assert len(seen.faces) == 3
        assert sum(_area(face.points) for face in seen.faces) == pytest.approx(_area(seen.points))


def _area(points: tuple[Point, ...]) -> float:
    pairs = ((points[at - 1], point) for at, point in enumerate(points))
    return abs(sum(one.x * other.y - one.y * other.x for one, other in pairs)) / 2


@pytest.mark.parametrize("view", VIEWS, ids=lambda view: view.key)
def test_views_are_right_handed(view: View) -> None:
    assert cross(view.right, view.up) == view.near


def test_views_stand_in_third_angle_projection() -> None:
    """What is above, beside each other has the same x and z: what is nearer is next to it."""
    top, side, front = VIEWS
    assert top.right == side.right and side.up == front.up
    # Above the side view is what one sees from above, right of it what one sees from its right.
    assert top.near == side.up and front.near == side.right


def test_hull() -> None:
    square = [Point(0, 0), Point(2, 0), Point(2, 2), Point(0, 2)]
    assert hull([*square, Point(1, 1), Point(1, 0), Point(2, 2)]) == tuple(square)
    assert hull([Point(1, 1)] * 3) == (Point(1, 1),)


@pytest.mark.parametrize(
    ("points", "rows", "found"),
    [
        ([Point(0, 0), Point(4, 0), Point(4, 2), Point(0, 2)], 9, [(0, 0, 4), (1, 0, 4)]),
        ([Point(0, 0), Point(2, 2), Point(0, 2)], 9, [(0, 0, 0.5), (1, 0, 1.5)]),
        # Thinner than a row; of the height of none; above and below all of them.
        ([Point(1, 1.2), Point(5, 1.2)], 9, [(1, 1, 5)]),
        ([Point(1, 1.2), Point(5, 1.2), Point(5, 1.4), Point(1, 1.4)], 9, [(1, 1, 5)]),
        ([Point(0, -5), Point(4, -5), Point(4, -3)], 9, []),
        ([Point(0, 9.5), Point(4, 9.5), Point(4, 12)], 9, []),
    ],
)  # fmt: skip
def test_rows_of_a_polygon(
    points: list[Point], rows: int, found: list[tuple[int, float, float]]
) -> None:
    assert [tuple(each) for each in stretches(points, rows)] == found


@pytest.mark.parametrize(
    ("longest", "text"),
    [
        (0.19, "0.1 m"), (0.2, "0.2 m"), (7.0, "5 m"), (123.0, "100 m"), (1.0, "1 m"),
        (0.00099, "0.0005 m"), (25.0, "20 m"), (0.05, "0.05 m"),
    ],
)  # fmt: skip
def test_rulers_are_round(longest: float, text: str) -> None:
    assert ruler_text(ruler_length(longest)) == text
