"""What follows from the shape and the place of a body: its inertia, and where its middle is."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from math import isclose

from .description import Body, Inertial, Mesh, Tensor, Vector
from .inertia import tensor_of, turned
from .transforms import Transform, rotation_matrix, seen_from

MeshBounds = Callable[[str], "tuple[Vector, Vector] | None"]
"""Returns the lowest and the highest corner of a mesh, in its own lengths; None where nobody
knows them."""

_CLOSE = 1e-2
"""How far an inertia may be from that of its shape, and still be meant to follow from it.

People write two or three digits: 0.0417 for 5 / 120."""

_SAME_PLACE = 1e-4
"""Metres: how far the center of mass may be from the middle of the shape likewise."""


class Bodies:
    """Tells what follows from the shapes of bodies; a mesh counts as the box around it."""

    def __init__(self, mesh_bounds: MeshBounds) -> None:
        """Set what tells where meshes end."""
        self._mesh_bounds = mesh_bounds

    def tensor(self, body: Body, mass: float, rotation: Vector | None = None) -> Tensor | None:
        """Return the inertia of a body about its middle, None where nobody knows it.

        Args:
            body: the body.
            mass: what it weighs, in kg.
            rotation: how the axes are turned that it is in; None for those of the body.
        """
        shape = body.shape
        if shape is None:
            return None
        size = None
        if isinstance(shape, Mesh):
            box = self._box(shape)
            size = None if box is None else _vector(high - low for low, high in box)
        tensor = tensor_of(shape, mass, size)
        if tensor is None or rotation in (None, body.pose.rotation):
            return tensor
        axes = seen_from(rotation_matrix(rotation), rotation_matrix(body.pose.rotation))
        return turned(tensor, axes)

    def middle(self, body: Body) -> Vector:
        """Return where the middle of a body is: that of a mesh is the middle of its box."""
        box = self._box(body.shape) if isinstance(body.shape, Mesh) else None
        if box is None:
            return body.pose.position
        return Transform().then(body.pose).point(_vector((low + high) / 2 for low, high in box))

    def follows(self, inertial: Inertial, body: Body) -> bool:
        """Tell whether an inertia is that of a body, its mass and its place."""
        tensor = self.tensor(body, inertial.mass, inertial.pose.rotation)
        if tensor is None:
            return False
        slack = _CLOSE * max(map(abs, tensor))
        return all(
            isclose(one, other, abs_tol=slack)
            for one, other in zip(inertial.tensor, tensor, strict=True)
        ) and all(
            isclose(one, other, abs_tol=_SAME_PLACE)
            for one, other in zip(inertial.pose.position, self.middle(body), strict=True)
        )

    def _box(self, mesh: Mesh) -> list[tuple[float, float]] | None:
        """Return where a mesh begins and ends along each of its axes, None where nobody knows.

        One with a negative scale is mirrored, and ends before it begins.
        """
        corners = self._mesh_bounds(mesh.uri)
        if corners is None:
            return None
        return [(a * scale, b * scale) for a, b, scale in zip(*corners, mesh.scale, strict=True)]


def _vector(values: Iterable[float]) -> Vector:
    x, y, z = values
    return x, y, z
