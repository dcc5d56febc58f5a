"""What a robot consists of: links, and the joints that hold them together."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum
from typing import NamedTuple, TypeAlias

Vector: TypeAlias = tuple[float, float, float]
Rgba: TypeAlias = tuple[float, float, float, float]

ORIGIN: Vector = (0.0, 0.0, 0.0)


class Pose(NamedTuple):
    """Where something is and how it is turned, seen from what holds it.

    Attributes:
        position: x, y, z.
        rotation: roll, pitch, yaw: about the fixed axes x, y and z, one after the other.
    """

    position: Vector = ORIGIN
    rotation: Vector = ORIGIN


class Box(NamedTuple):
    """A box around its middle."""

    size: Vector


class Cylinder(NamedTuple):
    """A cylinder around its middle, along its z axis."""

    radius: float
    length: float


class Sphere(NamedTuple):
    """A sphere around its middle."""

    radius: float


class Mesh(NamedTuple):
    """A body whose surface is in a file.

    Attributes:
        uri: `package://PACKAGE/PATH`, `file://PATH`, or a path.
        scale: what the file's lengths are multiplied with.
    """

    uri: str
    scale: Vector = (1.0, 1.0, 1.0)


Shape: TypeAlias = Box | Cylinder | Sphere | Mesh


class Material(NamedTuple):
    """How a body looks.

    Attributes:
        name: what it is called; a material that the robot has may be meant by its name alone.
        rgba: red, green, blue and opacity, from 0 to 1; None where only a name is given.
        texture: the file of a picture, None for none.
    """

    name: str
    rgba: Rgba | None = None
    texture: str | None = None


class Body(NamedTuple):
    """What of a link is seen, or what it collides with.

    Attributes:
        shape: its shape; None where its description has none that is known.
        pose: where its middle is, seen from the link.
        material: how it looks; None for what is not seen, or where nothing is said.
        name: what it is called, "" for nothing.
    """

    shape: Shape | None
    pose: Pose = Pose()
    material: Material | None = None
    name: str = ""


class Tensor(NamedTuple):
    """Moments and products of inertia about the center of mass, in kg m²."""

    ixx: float
    ixy: float
    ixz: float
    iyy: float
    iyz: float
    izz: float


class Inertial(NamedTuple):
    """How heavy a link is, and how hard to turn; the pose is that of its center of mass."""

    mass: float
    tensor: Tensor
    pose: Pose = Pose()


class Link(NamedTuple):
    """A rigid part."""

    name: str
    visuals: tuple[Body, ...] = ()
    collisions: tuple[Body, ...] = ()
    inertial: Inertial | None = None


class JointType(str, Enum):
    """How a child moves, seen from its parent."""

    REVOLUTE = "revolute"
    CONTINUOUS = "continuous"
    PRISMATIC = "prismatic"
    FIXED = "fixed"
    FLOATING = "floating"
    PLANAR = "planar"

    @property
    def is_limited(self) -> bool:
        """Whether URDF wants limits (urdfdom: `parseJoint`)."""
        return self in (JointType.REVOLUTE, JointType.PRISMATIC)

    @property
    def turns(self) -> bool:
        """Whether what it has a position of is an angle."""
        return self in (JointType.REVOLUTE, JointType.CONTINUOUS)

    @property
    def has_axis(self) -> bool:
        """Whether it moves about an axis, or along one, or across one."""
        return self not in (JointType.FIXED, JointType.FLOATING)


class Limit(NamedTuple):
    """How far, how strongly and how fast a joint moves; radians, or metres."""

    lower: float = 0.0
    upper: float = 0.0
    effort: float = 0.0
    velocity: float = 0.0


class Dynamics(NamedTuple):
    """What holds a joint back: damping in N m s/rad or N s/m, friction in N m or N."""

    damping: float = 0.0
    friction: float = 0.0


class Mimic(NamedTuple):
    """A joint that another one follows: its position times `multiplier`, plus `offset`."""

    joint: str
    multiplier: float = 1.0
    offset: float = 0.0


class Joint(NamedTuple):
    """What holds a link, the child, to another one, the parent.

    Attributes:
        name: what it is called.
        type: how the child moves.
        parent: the name of the link that holds.
        child: the name of the link that is held.
        pose: where the child is while the joint is at 0, seen from the parent.
        axis: what it moves about or along, seen from the child; None where nothing is said, which
            means x.
        limit: None where nothing is said, as `dynamics` and `mimic` are.
    """

    name: str
    type: JointType
    parent: str
    child: str
    pose: Pose = Pose()
    axis: Vector | None = None
    limit: Limit | None = None
    dynamics: Dynamics | None = None
    mimic: Mimic | None = None


@dataclass(frozen=True, slots=True)
class Description:
    """A robot, as it is at one time; what changes it makes another one.

    Its mappings are not frozen: whoever makes one may keep them and change them, as
    `model.robots.Robot` does while a program runs, and gives `Robot.snapshot` to who keeps it.

    Attributes:
        name: what it is called.
        links: its links by name, in their order.
        joints: its joints likewise.
        materials: those that all links may mean by their names.
    """

    name: str
    links: Mapping[str, Link] = field(default_factory=dict)
    joints: Mapping[str, Joint] = field(default_factory=dict)
    materials: Mapping[str, Material] = field(default_factory=dict)
