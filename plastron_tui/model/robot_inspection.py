"""What `plastron inspect` prints for the description of a robot."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from plastron_tui.ros.robots.description import (
    Body,
    Box,
    Cylinder,
    Description,
    Inertial,
    Joint,
    Link,
    Material,
    Mesh,
    Pose,
    Shape,
    Sphere,
)
from plastron_tui.ros.robots.macros import Macros
from plastron_tui.ros.robots.tree import branches, roots

from .robot_macros import macro_rows, macros_json
from .robot_words import limit_words, mass_words, number, numbers, shape_words


def robot_json(robot: Description, path: Path, macros: Macros | None = None) -> dict[str, Any]:
    """Describe a robot as JSON, in metres, kilograms and radians.

    A key is there only where the file says something of it, or has to; `macros` is what the file
    leaves to macros, be they expanded or not.
    """
    told = {} if macros is None else {"macros": macros_json(macros)}
    return {"file": str(path), "robot": robot.name, **parts_json(robot), **told}


def parts_json(robot: Description) -> dict[str, Any]:
    """Describe what a robot consists of."""
    found = roots(robot)
    return {
        "root": found[0] if len(found) == 1 else None,
        "links": [_link(each) for each in robot.links.values()],
        "joints": [_joint(each) for each in robot.joints.values()],
        "materials": [_material(each) for each in robot.materials.values()],
    }


def _link(link: Link) -> dict[str, Any]:
    found: dict[str, Any] = {"name": link.name}
    if link.inertial is not None:
        found["inertial"] = _inertial(link.inertial)
    found["visuals"] = [_body(each) for each in link.visuals]
    found["collisions"] = [_body(each) for each in link.collisions]
    return found


def _inertial(inertial: Inertial) -> dict[str, Any]:
    return {
        "mass": inertial.mass,
        "inertia": inertial.tensor._asdict(),
        **_pose(inertial.pose),
    }


def _pose(pose: Pose) -> dict[str, Any]:
    return {"position": list(pose.position), "rotation": list(pose.rotation)}


def _body(body: Body) -> dict[str, Any]:
    found: dict[str, Any] = {"name": body.name} if body.name else {}
    found |= _shape(body.shape) | _pose(body.pose)
    if body.material is not None:
        found["material"] = _material(body.material)
    return found


def _shape(shape: Shape | None) -> dict[str, Any]:
    match shape:
        case Box(size=size):
            return {"shape": "box", "size": list(size)}
        case Cylinder(radius=radius, length=length):
            return {"shape": "cylinder", "radius": radius, "length": length}
        case Sphere(radius=radius):
            return {"shape": "sphere", "radius": radius}
        case Mesh(uri=uri, scale=scale):
            return {"shape": "mesh", "uri": uri, "scale": list(scale)}
        case None:
            return {"shape": None}


def _material(material: Material) -> dict[str, Any]:
    found: dict[str, Any] = {"name": material.name}
    if material.rgba is not None:
        found["rgba"] = list(material.rgba)
    if material.texture is not None:
        found["texture"] = material.texture
    return found


def _joint(joint: Joint) -> dict[str, Any]:
    found: dict[str, Any] = {
        "name": joint.name,
        "type": joint.type.value,
        "parent": joint.parent,
        "child": joint.child,
        **_pose(joint.pose),
    }
    if joint.axis is not None:
        found["axis"] = list(joint.axis)
    for key in ("limit", "dynamics", "mimic"):
        part = getattr(joint, key)
        if part is not None:
            found[key] = part._asdict()
    return found


def robot_text(robot: Description, path: Path, macros: Macros | None = None) -> str:
    """Describe a robot for people: its tree, a line for each link with the joint that holds it.

    Args:
        robot: the robot.
        path: its file.
        macros: what the file leaves to macros that are not expanded, None for nothing.
    """
    lines = [f"{path} (URDF)", f"  robot {robot.name or '(without a name)'}"]
    lines += _columns(list(_rows(robot)))
    if macros is not None:
        lines += ["  not expanded", *_columns(list(macro_rows(macros)))]
    return "\n".join(lines)


def _columns(rows: Sequence[tuple[str, str, str]]) -> list[str]:
    widths = [max(map(len, column), default=0) for column in zip(*rows, strict=True)]
    return ["    " + "  ".join(map(str.ljust, row, widths)).rstrip() for row in rows]


def _rows(robot: Description) -> Iterator[tuple[str, str, str]]:
    written = set()
    for link, joint, depth in branches(robot):
        written.add(link)
        yield _row(robot.links[link], joint, depth)
    # What hangs in a circle has no root to be reached from.
    yield from (_row(each, None, 0) for name, each in robot.links.items() if name not in written)
    for each in robot.joints.values():
        if each.child not in robot.links:
            yield (
                f"joint {each.name}",
                each.type.value,
                f"holds `{each.child}`, which is not there",
            )


def _row(link: Link, joint: Joint | None, depth: int) -> tuple[str, str, str]:
    held = "" if joint is None else f"{joint.type.value} {joint.name}"
    return "  " * depth + link.name, held, ", ".join((*_told(link), *_moved(joint)))


def _told(link: Link) -> Iterator[str]:
    """Yield what a link is, in the words of a program."""
    shapes = dict.fromkeys(
        shape_words(each.shape) for each in link.visuals or link.collisions if each.shape
    )
    yield from shapes
    if link.inertial is not None:
        yield mass_words(link.inertial.mass)


def _moved(joint: Joint | None) -> Iterator[str]:
    if joint is None:
        return
    if any(joint.pose.position):
        yield f"at {numbers(joint.pose.position)}"
    if joint.axis is not None and joint.type.has_axis:
        yield f"axis {numbers(joint.axis)}"
    if joint.limit is not None and joint.type.is_limited:
        yield limit_words(joint)
    if joint.mimic is not None:
        times = "" if joint.mimic.multiplier == 1 else f" times {number(joint.mimic.multiplier)}"
        yield f"mimicking {joint.mimic.joint}{times}"
