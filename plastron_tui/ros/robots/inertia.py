"""Inertia of bodies of even density, and which one a body can have at all."""

from __future__ import annotations

from collections.abc import Sequence

from .description import Box, Cylinder, Mesh, Shape, Sphere, Tensor, Vector
from .transforms import Matrix

_SLACK = 1e-6
"""How far beyond what a body can have a description may be that was written with few digits."""


def tensor_of(shape: Shape, mass: float, size: Vector | None = None) -> Tensor | None:
    """Return the inertia of a body about its middle, in its own axes.

    Args:
        shape: its shape.
        mass: what it weighs.
        size: how large a mesh is along its axes, in metres; it counts as the box around it.

    Returns:
        None for a mesh of which nobody knows how large it is.
    """
    match shape:
        case Box(size=(x, y, z)):
            return _box(mass, x, y, z)
        case Cylinder(radius=radius, length=length):
            across = mass * (3 * radius * radius + length * length) / 12
            return Tensor(across, 0.0, 0.0, across, 0.0, mass * radius * radius / 2)
        case Sphere(radius=radius):
            each = mass * radius * radius * 2 / 5
            return Tensor(each, 0.0, 0.0, each, 0.0, each)
        case Mesh():
            return None if size is None else _box(mass, *size)


def _box(mass: float, x: float, y: float, z: float) -> Tensor:
    return Tensor(
        mass * (y * y + z * z) / 12,
        0.0,
        0.0,
        mass * (x * x + z * z) / 12,
        0.0,
        mass * (x * x + y * y) / 12,
    )


def turned(tensor: Tensor, rotation: Matrix) -> Tensor:
    """Return an inertia in other axes, seen from which its own are turned by a rotation."""
    ixx, ixy, ixz, iyy, iyz, izz = tensor
    rows = ((ixx, ixy, ixz), (ixy, iyy, iyz), (ixz, iyz, izz))
    between = [[_dot(row, line) for row in rows] for line in rotation]

    def at(row: int, column: int) -> float:
        return _dot(between[row], rotation[column])

    return Tensor(at(0, 0), at(0, 1), at(0, 2), at(1, 1), at(1, 2), at(2, 2))


def _dot(one: Sequence[float], other: Sequence[float]) -> float:
    return one[0] * other[0] + one[1] * other[1] + one[2] * other[2]


def is_possible(tensor: Tensor) -> bool:
    """Tell whether a body can have an inertia.

    Its principal moments are positive, and none is more than the other two together: what turns
    about one axis is not on the other two. Both hold if and only if the matrix of second moments,
    half the trace less the tensor, has no negative eigenvalue.
    """
    half = (tensor.ixx + tensor.iyy + tensor.izz) / 2
    a, b, c = half - tensor.ixx, half - tensor.iyy, half - tensor.izz
    d, e, f = -tensor.ixy, -tensor.ixz, -tensor.iyz
    if not half > 0:
        return False
    slack = _SLACK * half
    minors = (a * b - d * d, a * c - e * e, b * c - f * f)
    determinant = a * (b * c - f * f) - d * (d * c - f * e) + e * (d * f - b * e)
    return (
        min(a, b, c) >= -slack
        and min(minors) >= -slack * half
        and determinant >= -slack * half * half
    )
