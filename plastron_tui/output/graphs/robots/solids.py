"""What is drawn of a robot: bodies and axes, in the frame of its root, with all joints at 0."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from math import hypot, isfinite
from typing import NamedTuple, TypeAlias

from plastron_tui.ros.robots.description import (
    Body,
    Box,
    Cylinder,
    Description,
    JointType,
    Link,
    Material,
    Mesh,
    Pose,
    Rgba,
    Sphere,
    Vector,
)
from plastron_tui.ros.robots.materials import defined_materials, meant
from plastron_tui.ros.robots.transforms import Transform, placed
from plastron_tui.ros.robots.tree import holders

from .captions import bodies_of

MeshBounds: TypeAlias = Callable[[str], "tuple[Vector, ...] | None"]
"""Returns points that a mesh is between, by its URI, in its file's lengths.

Two are corners of the box around it, more have about the convex hull that the mesh has. None
where nobody knows.
"""

_FARTHEST = 1e9
"""What is farther away than this, in metres, cannot be meant, and is not drawn."""


class Hull(NamedTuple):
    """A body that is around points."""

    points: tuple[Vector, ...]


class Solid(NamedTuple):
    """A body to draw.

    Attributes:
        link: the link that it is of.
        shape: its shape; None for a mesh of which nobody knows how large it is.
        at: what places it.
        rgba: its colour, None where nothing is said.
        is_rough: whether it is not what is seen: the box around a mesh, or what collides.
    """

    link: str
    shape: Box | Cylinder | Sphere | Hull | None
    at: Transform
    rgba: Rgba | None = None
    is_rough: bool = False


class Axis(NamedTuple):
    """A joint to draw.

    Attributes:
        joint: its name.
        type: how it moves.
        at: where it is.
        along: its axis, of length 1; None where it has none.
    """

    joint: str
    type: JointType
    at: Vector
    along: Vector | None


class Bone(NamedTuple):
    """From where to where a joint is: from its parent to its child."""

    start: Vector
    end: Vector


class Scene(NamedTuple):
    """All that is drawn of a robot.

    Attributes:
        solids: its bodies, in the order of the links.
        axes: its joints, in theirs.
        bones: what holds it together, where not all bodies can be drawn.
        points: where those of its links are that are drawn, or move.
        links: the names of its links.
        missing: what cannot be drawn: links that hang on no root, or are too far away.
    """

    solids: tuple[Solid, ...]
    axes: tuple[Axis, ...]
    bones: tuple[Bone, ...]
    points: tuple[Vector, ...]
    links: tuple[str, ...]
    missing: tuple[str, ...]


def no_bounds(uri: str) -> None:
    """Know no mesh."""


def scene_of(robot: Description, mesh_bounds: MeshBounds = no_bounds) -> Scene:
    """Return what is drawn of a robot."""
    where = {name: at for name, at in placed(robot).items() if _is_near(at)}
    materials = defined_materials(robot)
    solids: list[Solid] = []
    missing: list[str] = []
    for name, link in robot.links.items():
        if name not in where:
            missing.append(name)
            continue
        drawn = _drawn(link, where[name], materials, mesh_bounds)
        near = [solid for solid in drawn if _is_near(solid.at) and _is_small(solid.shape)]
        if len(near) < len(drawn):
            missing.append(name)
        solids += near
    axes = []
    bones = []
    # Of frames alone all are drawn.
    carrying = _carrying(robot, {solid.link for solid in solids}) or set(where)
    for joint in robot.joints.values():
        at = where.get(joint.child)
        # A link that two joints hold is where the first one has it.
        if at is None or joint.parent not in where:
            continue
        if joint.child in carrying and at.translation != where[joint.parent].translation:
            bones.append(Bone(where[joint.parent].translation, at.translation))
        along = _unit(at.direction(joint.axis or (1.0, 0.0, 0.0))) if joint.type.has_axis else None
        axes.append(Axis(joint.name, joint.type, at.translation, along))
    points = tuple(at.translation for name, at in where.items() if name in carrying)
    if solids and all(solid.shape is not None for solid in solids):
        bones = []
    names = tuple(robot.links)
    return Scene(tuple(solids), tuple(axes), tuple(bones), points, names, tuple(missing))


def _carrying(robot: Description, drawn: set[str]) -> set[str]:
    """Return the links that are drawn, that move, or that hold such a link, however far away."""
    found: set[str] = set()
    up = holders(robot)
    for name, joint in up.items():
        at: str | None = name
        if name not in drawn and joint.type is JointType.FIXED:
            continue
        while at is not None and at not in found:
            found.add(at)
            at = up[at].parent if at in up else None
    return found


def _drawn(
    link: Link, at: Transform, materials: Mapping[str, Material], mesh_bounds: MeshBounds
) -> list[Solid]:
    """Return the bodies of a link: what is seen of it, else what collides.

    What collides stands in for meshes, too, of which nobody knows how large they are.
    """
    seen = list(_solids(link.name, bodies_of(link), at, materials, mesh_bounds))
    if any(solid.shape is not None for solid in seen):
        return seen
    rgba = seen[0].rgba if seen else None
    found = _solids(link.name, link.collisions, at, materials, mesh_bounds)
    rough = [x._replace(rgba=rgba, is_rough=True) for x in found if x.shape is not None]
    return rough or seen


def _solids(
    link: str,
    bodies: tuple[Body, ...],
    at: Transform,
    materials: Mapping[str, Material],
    mesh_bounds: MeshBounds,
) -> Iterator[Solid]:
    for body in bodies:
        rgba = None if body.material is None else meant(body.material, materials).rgba
        here = at.then(body.pose)
        match body.shape:
            case None:
                continue
            case Mesh() as mesh:
                points = mesh_bounds(mesh.uri)
                if not points:
                    yield Solid(link, None, here, rgba)
                elif len(points) == 2:
                    low, high = points
                    box, middle = _box_around(mesh, (low, high))
                    yield Solid(link, box, here.then(Pose(middle)), rgba, is_rough=True)
                else:
                    yield Solid(link, Hull(_scaled(points, mesh.scale)), here, rgba)
            case shape:
                yield Solid(link, shape, here, rgba)


def _scaled(points: tuple[Vector, ...], scale: Vector) -> tuple[Vector, ...]:
    a, b, c = scale
    return tuple([(a * x, b * y, c * z) for x, y, z in points])


def _box_around(mesh: Mesh, bounds: tuple[Vector, Vector]) -> tuple[Box, Vector]:
    """Return the box around a mesh as it is scaled, and where its middle is."""
    low, high = bounds
    scaled = [
        (low[at] * mesh.scale[at], high[at] * mesh.scale[at]) for at in range(len(mesh.scale))
    ]
    (x, xx), (y, yy), (z, zz) = scaled
    middle = (x + xx) / 2, (y + yy) / 2, (z + zz) / 2
    return Box((abs(xx - x), abs(yy - y), abs(zz - z))), middle


def _is_near(at: Transform) -> bool:
    values = (*at.translation, *(value for row in at.rotation for value in row))
    return all(abs(value) < _FARTHEST for value in values)


def _is_small(shape: Box | Cylinder | Sphere | Hull | None) -> bool:
    match shape:
        case None:
            return True
        case Box(size=size):
            lengths: tuple[float, ...] = size
        case Cylinder(radius=radius, length=length):
            lengths = radius, length
        case Sphere(radius=radius):
            lengths = (radius,)
        case Hull(points=points):
            lengths = tuple(abs(length) for point in points for length in point)
    return all(0 <= length < _FARTHEST for length in lengths)


def _unit(along: Vector) -> Vector | None:
    length = hypot(*along)
    if not length or not isfinite(length):
        return None
    return along[0] / length, along[1] / length, along[2] / length
