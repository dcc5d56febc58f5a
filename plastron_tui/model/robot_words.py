"""Parts of robots in the words of programs."""

from __future__ import annotations

from collections.abc import Iterable
from math import degrees, isclose

from plastron_tui.ros.robots.colors import NAMES, rgba_of
from plastron_tui.ros.robots.description import (
    Box,
    Cylinder,
    Joint,
    Material,
    Mesh,
    Rgba,
    Shape,
    Sphere,
    Vector,
)

_DIGITS = 10
"""As many as the files of robots that Plastron writes have."""

_ROUND = 1e-6
"""How far an angle may be from one that people write in degrees, in degrees."""


def number(value: float) -> str:
    """Return a number as people write it: `0.1`, `5`."""
    text = f"{value:.{_DIGITS}g}"
    return "0" if text == "-0" else text


def numbers(values: Iterable[float]) -> str:
    """Return numbers with commas between them."""
    return ", ".join(map(number, values))


def shape_words(shape: Shape | None) -> str:
    """Return a shape as it stands behind `shaped`, "" for none."""
    match shape:
        case Box(size=size):
            return f"box {numbers(size)}"
        case Cylinder(radius=radius, length=length):
            return f"cylinder {numbers((radius, length))}"
        case Sphere(radius=radius):
            return f"sphere {number(radius)}"
        case Mesh(uri=uri, scale=scale):
            written = uri.replace("\\", "\\\\").replace('"', '\\"')
            sized = "" if scale == (1.0, 1.0, 1.0) else f", ({numbers(scale)})"
            return f'mesh "{written}"{sized}'
        case None:
            return ""


def mass_words(mass: float) -> str:
    """Return a mass for people."""
    return f"{number(mass)} kg"


def color_words(material: Material, materials: Iterable[str] = ()) -> str | None:
    """Return a colour as it stands behind `painted`, None for what a program cannot say.

    Args:
        material: what a body looks like.
        materials: the names that the robot has materials by.
    """
    rgba = material.rgba
    if material.texture is not None or rgba is None:
        return material.name if material.name in materials else None
    named = (name for name in NAMES if rgba_of(name) == rgba)
    return next(named, None) or f'"{_code(rgba)}"'


def _code(rgba: Rgba) -> str:
    parts = [round(min(max(part, 0.0), 1.0) * 255) for part in rgba]
    if parts[3] == 255:
        parts.pop()
    return "#" + "".join(f"{part:02x}" for part in parts)


def angle_words(angles: Vector | tuple[float, float], between: str = ", ") -> str:
    """Return angles with their unit: in degrees where they are those that people write."""
    turned = [degrees(angle) for angle in angles]
    if all(isclose(each, round(each, 2), abs_tol=_ROUND) for each in turned):
        return f"{between.join(number(round(each, 2)) for each in turned)} deg"
    return f"{between.join(map(number, angles))} rad"


def limit_words(joint: Joint) -> str:
    """Return how far a joint moves, as it stands behind `limits_joint`."""
    limit = joint.limit
    assert limit is not None, "it has limits"
    ends = (limit.lower, limit.upper)
    if joint.type.turns:
        return f"between {angle_words(ends, ' and ')}"
    return f"between {number(limit.lower)} and {number(limit.upper)} m"
