"""What the pictures of a robot say in words, so that all of them say the same."""

from __future__ import annotations

from math import degrees, hypot

from plastron_tui.diagnostics.terminal import visible
from plastron_tui.diagnostics.wording import counted
from plastron_tui.ros.robots.description import (
    Body,
    Box,
    Cylinder,
    Joint,
    JointType,
    Link,
    Mesh,
    Shape,
    Sphere,
    Vector,
)

_AXES = "xyz"
_CLOSE = 1e-4
"""How far a direction may be from an axis and still be called by its name."""

_MOVES = {
    JointType.REVOLUTE: "about",
    JointType.CONTINUOUS: "about",
    JointType.PRISMATIC: "along",
    JointType.PLANAR: "across",
}


def number_text(value: float) -> str:
    """Return a number with four digits that count; a zero has no sign."""
    text = f"{value:.4g}"
    return "0" if text == "-0" else text


def shape_text(shape: Shape) -> str:
    """Return what a body is like: `box 0.4 × 0.3 × 0.1 m`, `mesh wheel.stl`."""
    match shape:
        case Box(size=size):
            return f"box {' × '.join(map(number_text, size))} m"
        case Cylinder(radius=radius, length=length):
            return f"cylinder r {number_text(radius)}, l {number_text(length)} m"
        case Sphere(radius=radius):
            return f"sphere r {number_text(radius)} m"
        case Mesh(uri=uri):
            return f"mesh {visible(uri.rpartition('/')[2] or uri)}"


def bodies_of(link: Link) -> tuple[Body, ...]:
    """Return what is drawn of a link: what is seen of it, else what collides."""
    return link.visuals or link.collisions


def link_text(link: Link) -> str:
    """Return the caption of a link: its shape, of several how many, and its mass."""
    shapes = [body.shape for body in bodies_of(link) if body.shape is not None]
    parts = [shape_text(shapes[0])] if len(shapes) == 1 else []
    if len(shapes) > 1:
        parts = [f"{len(shapes)} shapes"]
    if link.inertial is not None:
        parts.append(f"{number_text(link.inertial.mass)} kg")
    return " · ".join(parts)


def axis_text(axis: Vector | None) -> str:
    """Return a direction: `x`, `-z`, `(0.6, 0, 0.8)`; the x axis where nothing is said."""
    if axis is None:
        return "x"
    length = hypot(*axis)
    if not 0 < length < float("inf"):
        return "no axis"
    unit = [value / length for value in axis]
    for name, value in zip(_AXES, unit, strict=True):
        if abs(abs(value) - 1) < _CLOSE:
            return name if value > 0 else f"-{name}"
    return f"({', '.join(number_text(round(value, 3)) for value in unit)})"


def joint_text(joint: Joint) -> str:
    """Return the caption of a joint: type, axis, how far it goes, and whom it follows."""
    parts = [joint.type.value]
    if joint.type.has_axis:
        parts[0] += f" {_MOVES[joint.type]} {axis_text(joint.axis)}"
    limits = limits_text(joint)
    if limits:
        parts.append(limits)
    if joint.mimic is not None:
        parts.append(f"follows {visible(joint.mimic.joint)}")
    return " · ".join(parts)


def limits_text(joint: Joint) -> str:
    """Return how far a joint goes, `-90° to 90°`; "" where URDF has no limits or none are said."""
    if joint.limit is None or not joint.type.is_limited:
        return ""
    low, high = joint.limit.lower, joint.limit.upper
    if joint.type.turns:
        return f"{number_text(degrees(low))}° to {number_text(degrees(high))}°"
    return f"{number_text(low)} to {number_text(high)} m"


def robot_text(name: str, links: int, joints: int) -> str:
    """Return what a robot is in a line."""
    return f"{visible(name)}: {counted(links, 'link')}, {counted(joints, 'joint')}"
