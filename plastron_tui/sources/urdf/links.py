"""Links of URDF files, and what is in them (urdfdom: `link.cpp`)."""

from __future__ import annotations

from plastron_tui.diagnostics.severity import Severity
from plastron_tui.ros.robots.description import (
    Body,
    Box,
    Cylinder,
    Inertial,
    Link,
    Material,
    Mesh,
    Pose,
    Shape,
    Sphere,
    Tensor,
    Vector,
)
from plastron_tui.ros.robots.quaternions import angles_of
from plastron_tui.sources.xml.document import Attribute, Element

from .values import Values, first, or_else
from .vocabulary import QUATERNION, has_quaternions

_SHAPES = ("box", "cylinder", "sphere", "mesh")


def link_of(element: Element, name: str, values: Values) -> Link:
    """Return a link; each `visual` and each `collision` is a body, also one that has no shape."""
    inertial = first(element, "inertial")
    return Link(
        name,
        tuple(body_of(each, values) for each in element.named("visual")),
        tuple(body_of(each, values) for each in element.named("collision")),
        None if inertial is None else inertial_of(inertial, values),
    )


def body_of(element: Element, values: Values) -> Body:
    """Return what a `visual` or a `collision` says."""
    material = first(element, "material") if element.name == "visual" else None
    return Body(
        _shape_in(element, values),
        pose_of(element, values),
        None if material is None else material_of(material, values),
        element.get("name") or "",
    )


def pose_of(element: Element, values: Values) -> Pose:
    """Return what the `origin` in an element says."""
    origin = first(element, "origin")
    if origin is None:
        return Pose()
    rotation = values.vector(origin, "rpy")
    quaternion = origin.attribute(QUATERNION)
    if quaternion is not None:
        rotation = _turned_by(quaternion, rotation, values)
    return Pose(or_else(values.vector(origin, "xyz")), or_else(rotation))


def _turned_by(found: Attribute, rpy: Vector | None, values: Values) -> Vector | None:
    """Return the angles of a quaternion, those of `rpy` where it does not count."""
    if not has_quaternions(values.document.root):
        message = f"`{QUATERNION}` counts from version 1.1 of URDF on, and this file is in 1.0"
        help_text = 'write `rpy` instead, or `version="1.1"` in `<robot>`'
        values.tell(message, found.span, help_text, severity=Severity.WARNING)
        return rpy
    if rpy is not None:
        message = f"`rpy` and `{QUATERNION}` both say how this is turned"
        values.tell(message, found.span, "urdfdom reads no file with both: take one away")
        return rpy
    quaternion = values.quaternion(found)
    angles = None if quaternion is None else angles_of(quaternion)
    if quaternion is not None and angles is None:
        message = "a quaternion of zeros turns nothing"
        values.tell(message, found.value_span, severity=Severity.WARNING)
    return angles


def _shape_in(element: Element, values: Values) -> Shape | None:
    geometry = values.needed_child(element, "geometry")
    if geometry is None:
        return None
    if not geometry.children:
        values.tell("the geometry is empty", geometry.name_span)
        return None
    return shape_of(geometry.children[0], values)


def shape_of(element: Element, values: Values) -> Shape | None:
    """Return the shape that an element is, None where it is none that is known."""
    match element.name:
        case "box":
            size = values.vector(element, "size", is_needed=True)
            return None if size is None else Box(size)
        case "cylinder":
            radius = values.number(element, "radius", is_needed=True)
            length = values.number(element, "length", is_needed=True)
            return None if radius is None or length is None else Cylinder(radius, length)
        case "sphere":
            radius = values.number(element, "radius", is_needed=True)
            return None if radius is None else Sphere(radius)
        case "mesh":
            filename = values.needed(element, "filename")
            scale = values.vector(element, "scale")
            return None if filename is None else Mesh(filename.value, or_else(scale, (1, 1, 1)))
        case _ if values.is_xacro and ":" in element.name:
            return None
        case "capsule" if has_quaternions(values.document.root):
            message = "a `<capsule>` is not read: it counts as no shape"
            values.tell(message, element.name_span, severity=Severity.WARNING)
            return None
        case _:
            names = ", ".join(f"`{each}`" for each in _SHAPES)
            message = f"`<{element.name}>` is no shape of URDF"
            help_text = f"they are {names}"
            if element.name == "capsule":
                message, help_text = f"{message} 1.0", "urdfdom reads it from version 1.1 on"
            values.tell(message, element.name_span, help_text)
            return None


def material_of(element: Element, values: Values, *, is_shared: bool = False) -> Material | None:
    """Return a material; of those that all links may mean, None for one without a name.

    Within a link, an empty name is that of a material that nobody else means, as some exporters
    write it.
    """
    name = element.get("name")
    if name is None:
        values.tell("the material has no name", element.name_span)
        if is_shared:
            return None
    color, texture = first(element, "color"), first(element, "texture")
    rgba = None if color is None else values.rgba(color)
    picture = None if texture is None else texture.get("filename")
    if is_shared and color is None and picture is None:
        message = f"the material `{name}` has neither a colour nor a texture"
        values.tell(message, element.name_span)
    return Material(name or "", rgba, picture)


def inertial_of(element: Element, values: Values) -> Inertial | None:
    """Return mass and inertia, None where one of them cannot be read."""
    pose = pose_of(element, values)
    mass = values.needed_child(element, "mass")
    inertia = values.needed_child(element, "inertia")
    kilograms = None if mass is None else values.number(mass, "value", is_needed=True)
    moments = _tensor(inertia, values)
    if kilograms is None or moments is None:
        return None
    if kilograms < 0:
        span = element.name_span
        values.tell("the mass is negative", span, severity=Severity.WARNING)
    return Inertial(kilograms, moments, pose)


def _tensor(element: Element | None, values: Values) -> Tensor | None:
    if element is None:
        return None
    numbers = [values.number(element, each, is_needed=True) for each in Tensor._fields]
    found = [each for each in numbers if each is not None]
    return Tensor(*found) if len(found) == len(numbers) else None
