"""What is wrong with a robot as a whole."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from enum import Enum, auto
from typing import NamedTuple

from .description import Box, Cylinder, Description, JointType, Link, Mesh, Shape, Sphere
from .inertia import is_possible
from .plausible import HEAVIEST, LONGEST
from .tree import branches, holders, roots


class FaultKind(Enum):
    """A kind of fault; those of joints say so."""

    NO_LINKS = auto()
    """It has none; the part is the robot."""
    LOOSE = auto()
    """No joint holds a link, and it is not the root; others: the root."""
    CIRCLE = auto()
    """Joints hold each other; the part is the last of them, others: all of them, in a row."""
    HELD_TWICE = auto()
    """A joint holds a link that another one holds; others: the link, and the other joint."""
    NO_PARENT = auto()
    """A joint is to hang on a link that is not there; others: the link."""
    NO_CHILD = auto()
    """A joint is to hold a link that is not there; others: the link."""
    NO_LIMITS = auto()
    """A joint lacks the limits that URDF wants (urdfdom: `parseJoint`)."""
    NO_RANGE = auto()
    """A joint with limits moves nowhere between them."""
    NO_VELOCITY = auto()
    """A joint with limits has a velocity of 0, at which nothing that plans moves it."""
    MIMICS_NOTHING = auto()
    """A joint follows one that is not there; others: that one."""
    MIMICS_FIXED = auto()
    """A joint follows one that does not move; others: that one."""
    MIMIC_CIRCLE = auto()
    """Joints follow each other; the part is the last of them, others: all of them, in a row."""
    MASS = auto()
    """The mass of a link is not positive."""
    SIZE = auto()
    """A length of a link is not positive."""
    INERTIA = auto()
    """No body has the inertia of a link."""
    ROOT_INERTIA = auto()
    """The root has an inertia, which KDL leaves out (`kdl_parser`: `treeFromUrdfModel`)."""
    WEIGHTLESS = auto()
    """What a joint moves has a shape and no inertia: Gazebo leaves it out, and all that hangs on it
    (sdformat: `CreateSDF`)."""
    LONG = auto()
    """A length or a place of a link or a joint is so far that it may be in millimetres."""
    HEAVY = auto()
    """A link is so heavy that its mass may be in grams."""
    NAME = auto()
    """The name of a link or a joint is one that tf2 does not take: empty, or with a slash first."""
    SHARED_NAME = auto()
    """A joint is called like a link, which Gazebo refuses (sdformat: names of siblings)."""

    @property
    def is_of_joint(self) -> bool:
        """Whether the part is a joint."""
        return self in _OF_JOINTS

    @property
    def is_lack(self) -> bool:
        """Whether something is only missing yet: a link, a joint, limits, a weight, say."""
        return self in _LACKS


_OF_JOINTS = frozenset(
    {
        *(FaultKind.CIRCLE, FaultKind.HELD_TWICE, FaultKind.NO_PARENT, FaultKind.NO_CHILD),
        *(FaultKind.NO_LIMITS, FaultKind.NO_RANGE, FaultKind.NO_VELOCITY),
        *(
            FaultKind.MIMICS_NOTHING,
            FaultKind.MIMICS_FIXED,
            FaultKind.MIMIC_CIRCLE,
            FaultKind.SHARED_NAME,
        ),
    }
)

_LACKS = frozenset(
    {
        *(FaultKind.NO_LINKS, FaultKind.LOOSE, FaultKind.NO_LIMITS, FaultKind.ROOT_INERTIA),
        FaultKind.WEIGHTLESS,
    }
)


class Fault(NamedTuple):
    """Something that is wrong with a robot.

    Attributes:
        kind: what it is.
        part: the name of the link or the joint that it is about.
        others: the names of those that it is about besides, as the kind says.
    """

    kind: FaultKind
    part: str
    others: tuple[str, ...] = ()


def faults(robot: Description, root: str | None = None) -> Iterator[Fault]:
    """Yield all that is wrong with a robot as a whole, each once.

    Args:
        robot: the robot.
        root: the link that is meant to be the root; None, or one that a joint holds, leaves that
            to what hangs on each.
    """
    if not robot.links:
        yield Fault(FaultKind.NO_LINKS, robot.name)
    yield from _tree_faults(robot, root)
    yield from _limit_faults(robot)
    yield from _mimic_faults(robot)
    for link in robot.links.values():
        yield from _link_faults(link)
    for name, joint in holders(robot).items():
        held = robot.links.get(name, Link(name))
        is_shaped = held.visuals or held.collisions
        if joint.type is not JointType.FIXED and is_shaped and held.inertial is None:
            yield Fault(FaultKind.WEIGHTLESS, name)
    for joint in robot.joints.values():
        if any(abs(each) > LONGEST for each in joint.pose.position):
            yield Fault(FaultKind.LONG, joint.name)
        if joint.name in robot.links:
            yield Fault(FaultKind.SHARED_NAME, joint.name)
    for name in (*robot.links, *robot.joints):
        if not name.strip() or name.startswith("/"):
            yield Fault(FaultKind.NAME, name)


def meant_root(robot: Description, root: str | None = None) -> str | None:
    """Return which root is meant to be the one, None where there is none.

    Of several that is what most hangs on; but where it has a weight, the first link, if that is
    a mere place.

    Args:
        robot: the robot.
        root: the link that is meant to be the root, as for `faults`.
    """
    sizes = _root_sizes(robot)
    if not sizes or root in sizes:
        return root if root in sizes else None
    first, most = next(iter(robot.links.values())), max(sizes, key=sizes.__getitem__)
    is_place = first.inertial is None and not first.visuals and not first.collisions
    is_meant = first.name in sizes and is_place and robot.links[most].inertial is not None
    return first.name if is_meant else most


def heavy_root(robot: Description, root: str | None = None) -> str | None:
    """Return the root that is meant if it has an inertia, else None; as `meant_root`."""
    main = meant_root(robot, root)
    return None if main is None or robot.links[main].inertial is None else main


def _root_sizes(robot: Description) -> dict[str, int]:
    """Return how many links hang on each root, itself among them."""
    sizes: dict[str, int] = {}
    root = ""
    for branch in branches(robot):
        root = branch.link if branch.joint is None else root
        sizes[root] = sizes.get(root, 0) + 1
    return sizes


def _tree_faults(robot: Description, root: str | None) -> Iterator[Fault]:
    held = holders(robot)
    for joint in robot.joints.values():
        if joint.parent not in robot.links:
            yield Fault(FaultKind.NO_PARENT, joint.name, (joint.parent,))
        if joint.child not in robot.links:
            yield Fault(FaultKind.NO_CHILD, joint.name, (joint.child,))
        elif held[joint.child] is not joint:
            others = (joint.child, held[joint.child].name)
            yield Fault(FaultKind.HELD_TWICE, joint.name, others)
    above = {joint.name: held[joint.parent].name for joint in held.values() if joint.parent in held}
    yield from _circles(FaultKind.CIRCLE, robot, above)
    main = meant_root(robot, root)
    if main is None:
        return
    yield from (Fault(FaultKind.LOOSE, each, (main,)) for each in roots(robot) if each != main)
    if robot.links[main].inertial is not None:
        yield Fault(FaultKind.ROOT_INERTIA, main)


def _circles(kind: FaultKind, robot: Description, after: Mapping[str, str]) -> Iterator[Fault]:
    """Yield a fault for each circle of joints, of which each has one at most that comes after."""
    order = {name: at for at, name in enumerate(robot.joints)}
    done: set[str] = set()
    for start in after:
        path: dict[str, int] = {}
        at = start
        while at in after and at not in done and at not in path:
            path[at] = len(path)
            at = after[at]
        if at in path:
            around = tuple(reversed(list(path)[path[at] :]))
            last = max(range(len(around)), key=lambda place: order[around[place]])
            yield Fault(kind, around[last], (*around[last + 1 :], *around[: last + 1]))
        done.update(path)


def _limit_faults(robot: Description) -> Iterator[Fault]:
    for joint in robot.joints.values():
        if not joint.type.is_limited:
            continue
        if joint.limit is None:
            yield Fault(FaultKind.NO_LIMITS, joint.name)
        elif not joint.limit.lower < joint.limit.upper:
            yield Fault(FaultKind.NO_RANGE, joint.name)
        elif joint.limit.velocity == 0:
            yield Fault(FaultKind.NO_VELOCITY, joint.name)


def _mimic_faults(robot: Description) -> Iterator[Fault]:
    after: dict[str, str] = {}
    for joint in robot.joints.values():
        if joint.mimic is None:
            continue
        followed = robot.joints.get(joint.mimic.joint)
        if followed is None:
            yield Fault(FaultKind.MIMICS_NOTHING, joint.name, (joint.mimic.joint,))
        elif followed.type is JointType.FIXED:
            yield Fault(FaultKind.MIMICS_FIXED, joint.name, (followed.name,))
        else:
            after[joint.name] = followed.name
    yield from _circles(FaultKind.MIMIC_CIRCLE, robot, after)


def _link_faults(link: Link) -> Iterator[Fault]:
    bodies = (*link.visuals, *link.collisions)
    lengths = [length for body in bodies for length in _lengths(body.shape)]
    # A sphere of no size touches in a point: walking robots are described so.
    points = [each for each in bodies if isinstance(each.shape, Sphere) and not each.shape.radius]
    if sum(each > 0 for each in lengths) + len(points) < len(lengths):
        yield Fault(FaultKind.SIZE, link.name)
    places = [each for body in bodies for each in body.pose.position]
    if any(abs(each) > LONGEST for each in (*lengths, *places)):
        yield Fault(FaultKind.LONG, link.name)
    if link.inertial is None:
        return
    if link.inertial.mass > HEAVIEST:
        yield Fault(FaultKind.HEAVY, link.name)
    if not link.inertial.mass > 0:
        # A mere place, said with zeros.
        if link.inertial.mass == 0 and not any(link.inertial.tensor):
            return
        yield Fault(FaultKind.MASS, link.name)
        if not any(link.inertial.tensor):
            return
    if not is_possible(link.inertial.tensor):
        yield Fault(FaultKind.INERTIA, link.name)


def _lengths(shape: Shape | None) -> tuple[float, ...]:
    match shape:
        case Box(size=size):
            return size
        case Cylinder(radius=radius, length=length):
            return radius, length
        case Sphere(radius=radius):
            return (radius,)
        case Mesh() | None:
            return ()
