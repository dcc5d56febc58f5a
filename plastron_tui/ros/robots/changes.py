"""Links made of what is said of them, and changed by it."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from enum import Enum, auto
from math import isfinite
from typing import NamedTuple

from .bodies import Bodies, MeshBounds
from .description import Body, Inertial, Link, Material, Mesh, Pose, Shape, Tensor, Vector

NO_MATERIAL = Material("")
"""Said of a link that is to have no colour of its own."""


class LinkValues(NamedTuple):
    """What is said of a link; None where nothing is.

    Attributes:
        shape: what it is like.
        mass: what it weighs, in kg.
        material: how it looks; `NO_MATERIAL` for no way of its own.
        position: where the middle of its shape is, in metres.
        rotation: how its shape is turned, in radians.
    """

    shape: Shape | None = None
    mass: float | None = None
    material: Material | None = None
    position: Vector | None = None
    rotation: Vector | None = None


class Note(Enum):
    """What somebody is told of a link that is made or changed."""

    NO_SHAPE = auto()
    """Refused: what is said is about a shape, and the link has none."""
    SEVERAL_SHAPES = auto()
    """Refused: it has several shapes, and nothing says which is meant."""
    NOT_SEEN = auto()
    """Refused: it is painted, and has nothing that is seen."""
    BOX_INERTIA = auto()
    """The inertia of a mesh is that of the box around it."""
    UNKNOWN_SIZE = auto()
    """Nobody knows how large its mesh is, so that no inertia follows from it."""
    INERTIA_STAYS = auto()
    """Its inertia did not follow from its shape, and stays as it is."""
    OTHER_COLLISION = auto()
    """What is seen and what collides had two shapes, and have one now."""
    OTHERS_STAY = auto()
    """What is seen or collides has such a shape, and changes; what has another one stays."""
    APART = auto()
    """What collides, or the center of mass, was elsewhere, and stays there."""

    @property
    def is_refusal(self) -> bool:
        """Whether the link stays as it is."""
        return self in (Note.NO_SHAPE, Note.SEVERAL_SHAPES, Note.NOT_SEEN)


class Changed(NamedTuple):
    """A link that was made or changed.

    Attributes:
        link: the link; as it was, where a note refuses the change.
        notes: what somebody is told of it, each with the field of `LinkValues` that it is about.
    """

    link: Link
    notes: tuple[tuple[Note, str], ...] = ()


def new_link(name: str, values: LinkValues, mesh_bounds: MeshBounds) -> Changed:
    """Return a link of which this is all that is known."""
    link = Link(name)
    if values.shape is None:
        said = _first_said(values, LinkValues._fields)
        return Changed(link, ((Note.NO_SHAPE, said),) if said else ())
    body = Body(values.shape, _placed(Pose(), values))
    link = Link(name, (_painted(body, values.material),), (body,))
    if values.mass is None:
        return Changed(link)
    return _with_inertia(link, values.mass, Bodies(mesh_bounds))


def changed_link(link: Link, values: LinkValues, mesh_bounds: MeshBounds) -> Changed:
    """Return a link with what is said of it changed, and nothing else.

    What is seen and what collides get one shape, and are moved and turned alike where they were
    alike; but where only one of them has a shape of the kind that is said, only that one changes:
    the cylinder that collides, and not the mesh that is seen. A mass without a shape leaves the
    inertia in proportion. An inertia that followed from the shape follows from a new one, as does
    any where both shape and mass are said.
    """
    refusal = _refusal(link, values)
    if refusal is not None:
        return Changed(link, (refusal,))
    if not (link.visuals or link.collisions) and values.shape is not None:
        bodies = new_link(link.name, values._replace(mass=None), mesh_bounds).link
        new = link._replace(visuals=bodies.visuals, collisions=bodies.collisions)
        notes: list[tuple[Note, str]] = []
    else:
        new, notes = _with_bodies(link, values)
    changed = _with_inertial(link, new, values, Bodies(mesh_bounds))
    return Changed(changed.link, tuple(dict.fromkeys((*notes, *changed.notes))))


def _first_said(values: LinkValues, fields: Iterable[str]) -> str:
    return next((each for each in fields if getattr(values, each) is not None), "")


def _refusal(link: Link, values: LinkValues) -> tuple[Note, str] | None:
    """Return why a link cannot be changed as it is said, None where it can."""
    placing = _first_said(values, ("shape", "position", "rotation"))
    is_bare = not _bodies(link)
    weighs_first = values.mass is not None and link.inertial is None
    is_shapeless = all(each.shape is None for each in _bodies(link))
    if is_shapeless and values.shape is None:
        said = _first_said(values, ("position", "rotation", "material")) if is_bare else ""
        said = said or ("mass" if weighs_first else "")
        if said:
            return Note.NO_SHAPE, said
    said = placing if _has_several(link, values.shape) else ""
    said = said or ("mass" if weighs_first and _has_several(link, None) else "")
    if said:
        return Note.SEVERAL_SHAPES, said
    if values.material is not None and not (link.visuals or is_bare):
        return Note.NOT_SEEN, "material"
    return None


def _has_several(link: Link, shape: Shape | None) -> bool:
    """Tell whether several bodies of a kind may be meant, by a shape that is said or without."""
    meant = _meant(link, shape)
    return any(sum(map(meant, each)) > 1 for each in (link.visuals, link.collisions))


def _meant(link: Link, shape: Shape | None) -> Callable[[Body], bool]:
    """Return what tells which bodies a shape is said of: those of its kind, all if none is."""
    kinds = {type(each.shape) for each in _bodies(link)}
    if shape is None or type(shape) not in kinds:
        return lambda _: True
    return lambda body: isinstance(body.shape, type(shape))


def _with_bodies(link: Link, values: LinkValues) -> tuple[Link, list[tuple[Note, str]]]:
    """Return a link with its bodies changed, of which it has one of each kind where they move."""
    notes = []
    bodies = _bodies(link)
    main = bodies[0].pose if bodies else Pose()
    is_meant = _meant(link, values.shape)
    if not all(map(is_meant, bodies)):
        notes.append((Note.OTHERS_STAY, "shape"))
    elif values.shape is not None and len({each.shape for each in bodies}) > 1:
        notes.append((Note.OTHER_COLLISION, "shape"))
    elif values.shape is None and any(_stays(each.pose, main, values) for each in bodies):
        notes.append((Note.APART, _first_said(values, ("position", "rotation"))))

    def changed(body: Body) -> Body:
        if not is_meant(body):
            return body
        if values.shape is not None:
            # They are one shape from now on, and in one place where that is said.
            return body._replace(shape=values.shape, pose=_placed(body.pose, values))
        return body._replace(pose=_moved(body.pose, main, values))

    painted = [*filter(is_meant, link.visuals)] or [*link.visuals]
    visuals = tuple(
        _painted(changed(each), values.material if each in painted else None)
        for each in link.visuals
    )
    return link._replace(visuals=visuals, collisions=tuple(map(changed, link.collisions))), notes


def _painted(body: Body, material: Material | None) -> Body:
    """Return a body in another colour, if one is said."""
    if material is None:
        return body
    return body._replace(material=None if material == NO_MATERIAL else material)


def _placed(pose: Pose, values: LinkValues) -> Pose:
    return Pose(
        pose.position if values.position is None else values.position,
        pose.rotation if values.rotation is None else values.rotation,
    )


def _moved(pose: Pose, main: Pose, values: LinkValues) -> Pose:
    """Return where something is that goes along with what was at `main`, if it was there too."""
    position, rotation = pose
    if values.position is not None and position == main.position:
        position = values.position
    if values.rotation is not None and pose == main:
        rotation = values.rotation
    return Pose(position, rotation)


def _stays(pose: Pose, main: Pose, values: LinkValues) -> bool:
    """Tell whether something does not go along with what was at `main`."""
    is_elsewhere = values.position is not None and pose.position != main.position
    return is_elsewhere or (values.rotation is not None and pose != main)


def _with_inertial(old: Link, new: Link, values: LinkValues, bodies: Bodies) -> Changed:
    """Return a link with what it weighs after its bodies were changed."""
    inertial = old.inertial
    if inertial is None:
        return Changed(new) if values.mass is None else _with_inertia(new, values.mass, bodies)
    pairs = list(zip(_bodies(old), _bodies(new), strict=False))
    followed = [each for each in pairs if bodies.follows(inertial, each[0])]
    is_left = bool(followed) and all(before == after for before, after in followed)
    if values.shape is not None and values.mass is None and is_left:
        # What it follows from is not what changes.
        return Changed(new)
    if values.shape is not None and (followed or values.mass is not None):
        mass = inertial.mass if values.mass is None else values.mass
        # Its axes stay as they are where the file has some of its own.
        is_own = followed and inertial.pose.rotation != followed[0][0].pose.rotation
        rotation = inertial.pose.rotation if is_own else None
        return _with_inertia(new, mass, bodies, rotation, values.shape)
    notes = [] if values.shape is None else [(Note.INERTIA_STAYS, "shape")]
    if values.shape is None and followed:
        inertial = _carried(inertial, *followed[0], bodies)
    elif values.shape is None and pairs:
        main = pairs[0][0].pose
        if _stays(inertial.pose, main, values):
            notes.append((Note.APART, _first_said(values, ("position", "rotation"))))
        inertial = inertial._replace(pose=_moved(inertial.pose, main, values))
    if values.mass is not None:
        scaled = _scaled(inertial, values.mass)
        if scaled is None:
            return _with_inertia(new._replace(inertial=inertial), values.mass, bodies)
        inertial = scaled
    return Changed(new._replace(inertial=inertial), tuple(notes))


def _carried(inertial: Inertial, before: Body, after: Body, bodies: Bodies) -> Inertial:
    """Return the inertia that followed from a body, after the body was moved or turned."""
    if before.pose == after.pose:
        return inertial
    position = bodies.middle(after)
    if inertial.pose.rotation == before.pose.rotation:
        return inertial._replace(pose=Pose(position, after.pose.rotation))
    # Its axes are those of the link, which is not turned.
    tensor = bodies.tensor(after, inertial.mass, inertial.pose.rotation)
    pose = Pose(position, inertial.pose.rotation)
    return Inertial(inertial.mass, tensor or inertial.tensor, pose)


def _bodies(link: Link) -> tuple[Body, ...]:
    return *link.visuals, *link.collisions


def _scaled(inertial: Inertial, mass: float) -> Inertial | None:
    """Return an inertia of what is denser or less dense; None where it is that of nothing."""
    if not (inertial.mass > 0 and isfinite(inertial.mass) and any(inertial.tensor)):
        return None
    factor = mass / inertial.mass
    return Inertial(mass, Tensor(*(factor * each for each in inertial.tensor)), inertial.pose)


def _with_inertia(
    link: Link,
    mass: float,
    bodies: Bodies,
    rotation: Vector | None = None,
    shape: Shape | None = None,
) -> Changed:
    """Return a link whose inertia follows from its shape and a mass.

    Args:
        link: the link; an inertia that it has stays where none follows.
        mass: what it weighs.
        bodies: tells what follows from its shape.
        rotation: how the axes are turned that the inertia is in; None for those of the shape.
        shape: the one of several that is meant.
    """
    # What collides is what a simulation moves.
    collisions = sorted(link.collisions, key=lambda each: each.shape != shape)
    for body in (*collisions, *link.visuals):
        tensor = bodies.tensor(body, mass, rotation)
        if tensor is not None:
            turned_ = body.pose.rotation if rotation is None else rotation
            inertial = Inertial(mass, tensor, Pose(bodies.middle(body), turned_))
            is_mesh = isinstance(body.shape, Mesh)
            notes = ((Note.BOX_INERTIA, "mass"),) if is_mesh else ()
            return Changed(link._replace(inertial=inertial), notes)
    old = link.inertial
    if old is not None:
        link = link._replace(inertial=_scaled(old, mass) or old._replace(mass=mass))
    has_mesh = any(isinstance(each.shape, Mesh) for each in _bodies(link))
    note = Note.UNKNOWN_SIZE if has_mesh else Note.INERTIA_STAYS
    return Changed(link, ((note, "mass"),))
