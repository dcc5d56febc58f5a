"""The elements and attributes of URDF, in the order in which its specification has them."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from plastron_tui.sources.xml.document import Element
from plastron_tui.sources.xml.new_element import NewElement

CHILDREN: Mapping[str, tuple[str, ...]] = {
    "link": ("visual", "collision", "inertial"),
    "visual": ("origin", "geometry", "material"),
    "collision": ("origin", "geometry"),
    "geometry": ("box", "cylinder", "sphere", "mesh"),
    "material": ("color", "texture"),
    "inertial": ("origin", "mass", "inertia"),
    "joint": ("origin", "parent", "child", "axis", "limit", "dynamics", "mimic"),
}
ATTRIBUTES: Mapping[str, tuple[str, ...]] = {
    "link": ("name",),
    "joint": ("name", "type"),
    "visual": ("name",),
    "collision": ("name",),
    "material": ("name",),
    "origin": ("xyz", "rpy"),
    "box": ("size",),
    "cylinder": ("radius", "length"),
    "sphere": ("radius",),
    "mesh": ("filename", "scale"),
    "color": ("rgba",),
    "texture": ("filename",),
    "mass": ("value",),
    "inertia": ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"),
    "parent": ("link",),
    "child": ("link",),
    "axis": ("xyz",),
    "limit": ("lower", "upper", "effort", "velocity"),
    "dynamics": ("damping", "friction"),
    "mimic": ("joint", "multiplier", "offset"),
}
SAFETY, CALIBRATION = "safety_controller", "calibration"
"""What a joint may have besides, and what no sentence speaks of."""

QUATERNION = "quat_xyzw"
"""How an `origin` says since URDF 1.1 how something is turned, instead of by `rpy`."""

FIRST_VERSION, WITH_QUATERNIONS, LAST_VERSION = (1, 0), (1, 1), (1, 2)
"""The versions that urdfdom 6 reads, and the one from which on it reads quaternions, and a shape
of the name `capsule` (`URDFVersion`, `parsePoseInternal`, `parseGeometry`)."""

_VERSION = re.compile(r"([0-9]+)\.([0-9]+)")
_SINGLE: Mapping[str, frozenset[str]] = {
    "link": frozenset(("inertial",)),
    "joint": frozenset((*CHILDREN["joint"], SAFETY, CALIBRATION)),
    **{each: frozenset(CHILDREN[each]) for each in ("visual", "collision", "material", "inertial")},
}
"""What an element has one of."""


def version_of(robot: Element) -> tuple[int, int] | None:
    """Return the version of URDF that a `<robot>` names, None for what names none."""
    said = robot.get("version")
    if said is None:
        return FIRST_VERSION
    found = _VERSION.fullmatch(said)
    return None if found is None else (int(found.group(1)), int(found.group(2)))


def has_quaternions(robot: Element) -> bool:
    """Tell whether urdfdom looks at the quaternions of a robot."""
    return (version_of(robot) or FIRST_VERSION) >= WITH_QUATERNIONS


def second_children(element: Element) -> Iterator[Element]:
    """Yield the children that do not count, as there is one before that does (`FirstChildElement`).

    Of a `geometry`, that is whatever stands behind its first child.
    """
    if element.name == "geometry":
        yield from element.children[1:]
        return
    single = _SINGLE.get(element.name)
    if single is None or len(element.children) < 2:
        return
    seen: set[str] = set()
    for child in element.children:
        if child.name in single and child.name in seen:
            yield child
        seen.add(child.name)


def unknown_in(element: Element, new: NewElement | None = None) -> Iterator[str]:
    """Yield what an element says that is no word of URDF 1.0, as it stands there.

    Args:
        element: the element.
        new: what is written in its place, None for nothing.
    """
    is_known = element.name in ATTRIBUTES or element.name in CHILDREN
    if not (is_known or (new is not None and new.name == element.name)):
        yield f"<{element.name}>"
        return
    known = ATTRIBUTES.get(element.name, ())
    yield from (f'{one.name}="{one.value}"' for one in element.attributes if one.name not in known)
    for child in element.children:
        yield from unknown_in(child)
