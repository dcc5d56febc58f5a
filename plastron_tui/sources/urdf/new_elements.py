"""Parts of robots as elements of URDF, in the order in which its specification has them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from plastron_tui.ros.robots.description import (
    ORIGIN,
    Body,
    Box,
    Cylinder,
    Dynamics,
    Inertial,
    Joint,
    Limit,
    Link,
    Material,
    Mesh,
    Mimic,
    Pose,
    Shape,
    Sphere,
    Tensor,
    Vector,
)
from plastron_tui.sources.xml.new_element import NewElement

_DIGITS = 10
"""Beyond what anybody measures, and short enough for an angle of a third of a turn to be read."""

_WRITTEN_DIGITS = 12
"""So many digits people write, as in 1.57079632679; what is computed has more."""


def number(value: float) -> str:
    """Return a number as people write it: `0.1`, `5`, `1.570796327`."""
    text = f"{value:.{_WRITTEN_DIGITS}g}"
    return _shown(text) if float(text) == value else rounded(value)


def rounded(value: float) -> str:
    """Return a number with the digits that count."""
    return _shown(f"{value:.{_DIGITS}g}")


def _shown(text: str) -> str:
    return "0" if text == "-0" else text


def numbers(values: Iterable[float]) -> str:
    """Return numbers with spaces between them."""
    return " ".join(map(number, values))


def link_element(link: Link) -> NewElement:
    """Return a link."""
    children = [
        *(body_element("visual", each) for each in link.visuals),
        *(body_element("collision", each) for each in link.collisions),
        *(() if link.inertial is None else (inertial_element(link.inertial),)),
    ]
    return NewElement("link", (("name", link.name),), children=tuple(children))


def body_element(tag: str, body: Body) -> NewElement:
    """Return a `visual` or a `collision`."""
    children = [*origin_elements(body.pose)]
    if body.shape is not None:
        children.append(NewElement("geometry", children=(shape_element(body.shape),)))
    if body.material is not None:
        children.append(material_element(body.material))
    attributes = (("name", body.name),) if body.name else ()
    return NewElement(tag, attributes, children=tuple(children))


def origin_elements(pose: Pose) -> Iterator[NewElement]:
    """Yield the `origin` of a pose, none for one that is where it would be without."""
    if pose.position == ORIGIN and pose.rotation == ORIGIN:
        return
    turned = (("rpy", numbers(pose.rotation)),) if pose.rotation != ORIGIN else ()
    yield NewElement("origin", (("xyz", numbers(pose.position)), *turned))


def shape_element(shape: Shape) -> NewElement:
    """Return what a `geometry` holds."""
    match shape:
        case Box(size=size):
            return NewElement("box", (("size", numbers(size)),))
        case Cylinder(radius=radius, length=length):
            return NewElement("cylinder", (("radius", number(radius)), ("length", number(length))))
        case Sphere(radius=radius):
            return NewElement("sphere", (("radius", number(radius)),))
        case Mesh(uri=uri, scale=scale):
            scaled = (("scale", numbers(scale)),) if scale != (1.0, 1.0, 1.0) else ()
            return NewElement("mesh", (("filename", uri), *scaled))


def material_element(material: Material) -> NewElement:
    """Return a material, with its colour where it has one of its own."""
    children = []
    if material.rgba is not None:
        children.append(NewElement("color", (("rgba", numbers(material.rgba)),)))
    if material.texture is not None:
        children.append(NewElement("texture", (("filename", material.texture),)))
    return NewElement("material", (("name", material.name),), children=tuple(children))


def inertial_element(inertial: Inertial) -> NewElement:
    """Return mass, center and inertia of a link."""
    tensor = zip(Tensor._fields, map(number, inertial.tensor), strict=True)
    return NewElement(
        "inertial",
        children=(
            *origin_elements(inertial.pose),
            NewElement("mass", (("value", number(inertial.mass)),)),
            NewElement("inertia", tuple(tensor)),
        ),
    )


def joint_element(joint: Joint) -> NewElement:
    """Return a joint."""
    children = [
        *origin_elements(joint.pose),
        NewElement("parent", (("link", joint.parent),)),
        NewElement("child", (("link", joint.child),)),
    ]
    if joint.axis is not None:
        children.append(axis_element(joint.axis))
    if joint.limit is not None:
        children.append(limit_element(joint.limit, has_range=joint.type.is_limited))
    if joint.dynamics is not None:
        children.append(dynamics_element(joint.dynamics))
    if joint.mimic is not None:
        children.append(mimic_element(joint.mimic))
    attributes = (("name", joint.name), ("type", joint.type.value))
    return NewElement("joint", attributes, children=tuple(children))


def axis_element(axis: Vector) -> NewElement:
    """Return what a joint moves about or along."""
    return NewElement("axis", (("xyz", numbers(axis)),))


def limit_element(limit: Limit, *, has_range: bool) -> NewElement:
    """Return a limit; what turns without end has no range, unless it says one."""
    ends = tuple(
        (name, number(value))
        for name, value in (("lower", limit.lower), ("upper", limit.upper))
        if has_range or value
    )
    strength = (("effort", number(limit.effort)), ("velocity", number(limit.velocity)))
    return NewElement("limit", (*ends, *strength))


def dynamics_element(dynamics: Dynamics) -> NewElement:
    """Return what holds a joint back."""
    fields = zip(Dynamics._fields, map(number, dynamics), strict=True)
    return NewElement("dynamics", tuple(fields))


def mimic_element(mimic: Mimic) -> NewElement:
    """Return which joint another one follows; what is as it would be unsaid is not said."""
    multiplier = (("multiplier", number(mimic.multiplier)),) if mimic.multiplier != 1 else ()
    offset = (("offset", number(mimic.offset)),) if mimic.offset else ()
    return NewElement("mimic", (("joint", mimic.joint), *multiplier, *offset))
