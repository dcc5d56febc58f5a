"""Links and joints made of what is said of them, and changed by it."""

from __future__ import annotations

from collections.abc import Callable
from math import isclose
from typing import NamedTuple

from .description import (
    Body,
    Inertial,
    Joint,
    JointType,
    Link,
    Material,
    Mesh,
    Mimic,
    Pose,
    Shape,
    Tensor,
    Vector,
)
from .inertia import tensor_of

MeshSize = Callable[[str], Vector | None]
"""Returns how large a mesh is along its axes, in the file's lengths; None where nobody knows."""

_CLOSE = 1e-3
"""How far an inertia may be from that of its shape, and still be meant to follow from it."""


class LinkValues(NamedTuple):
    """What is said of a link; None where nothing is.

    Attributes:
        shape: what it is like.
        mass: what it weighs, in kg.
        material: how it looks.
        position: where the middle of its shape is, in metres.
        rotation: how its shape is turned, in radians.
    """

    shape: Shape | None = None
    mass: float | None = None
    material: Material | None = None
    position: Vector | None = None
    rotation: Vector | None = None


def new_link(name: str, values: LinkValues, mesh_size: MeshSize) -> Link:
    """Return a link of which this is all that is known."""
    if values.shape is None:
        return Link(name)
    pose = _moved(Pose(), values)
    body = Body(values.shape, pose)
    tensor = None if values.mass is None else _tensor(values.shape, values.mass, mesh_size)
    inertial = None
    if values.mass is not None and tensor is not None:
        inertial = Inertial(values.mass, tensor, pose)
    return Link(name, (body._replace(material=values.material),), (body,), inertial)


def changed_link(link: Link, values: LinkValues, mesh_size: MeshSize) -> Link:
    """Return a link with what is said of it changed, and nothing else.

    What is seen and what collides are changed alike where there is one of each. An inertia that
    followed from shape and mass does so again; another one stays.
    """
    visual = link.visuals[0] if link.visuals else None
    collision = link.collisions[0] if link.collisions else None
    # TODO: several bodies, inertia that follows
    del visual, collision, values, mesh_size
    return link


def changed_joint(
    joint: Joint,
    type_: JointType,
    ends: tuple[str, str],
    position: Vector | None,
    rotation: Vector | None,
    axis: Vector | None,
    mimic: Mimic | None,
) -> Joint:
    """Return a joint with what is said of it changed, and nothing else."""
    parent, child = ends
    return joint._replace(
        type=type_,
        parent=parent,
        child=child,
        pose=Pose(position or joint.pose.position, rotation or joint.pose.rotation),
        axis=joint.axis if axis is None else axis,
        mimic=joint.mimic if mimic is None else mimic,
    )


def follows(inertial: Inertial, shape: Shape, mesh_size: MeshSize) -> bool:
    """Tell whether an inertia is that of a shape and its mass."""
    tensor = _tensor(shape, inertial.mass, mesh_size)
    return tensor is not None and all(
        isclose(one, other, rel_tol=_CLOSE, abs_tol=_CLOSE * max(map(abs, tensor)))
        for one, other in zip(inertial.tensor, tensor, strict=True)
    )


def _tensor(shape: Shape, mass: float, mesh_size: MeshSize) -> Tensor | None:
    size = None
    if isinstance(shape, Mesh):
        extent = mesh_size(shape.uri)
        if extent is not None:
            x, y, z = (abs(a * b) for a, b in zip(extent, shape.scale, strict=True))
            size = x, y, z
    return tensor_of(shape, mass, size)


def _moved(pose: Pose, values: LinkValues) -> Pose:
    return Pose(
        pose.position if values.position is None else values.position,
        pose.rotation if values.rotation is None else values.rotation,
    )
