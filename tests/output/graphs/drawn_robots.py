"""Robots to draw: small ones by hand, any at all, and what is in their pictures."""

from __future__ import annotations

import random
import re
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from math import pi
from typing import NamedTuple

from hypothesis import strategies as st

from plastron_tui.diagnostics import Span
from plastron_tui.model.graph import GraphRobot
from plastron_tui.output.graphs.robots.views import Frame
from plastron_tui.output.graphs.widths import text_width
from plastron_tui.ros.robots.description import (
    Body,
    Box,
    Cylinder,
    Description,
    Inertial,
    Joint,
    JointType,
    Limit,
    Link,
    Material,
    Mesh,
    Pose,
    Shape,
    Sphere,
    Tensor,
    Vector,
)

_HERE = Pose()
SVG = "{http://www.w3.org/2000/svg}"
_TRANSLATE = re.compile(r"translate\((-?[\d.]+) (-?[\d.]+)\)")
_COMMAND = re.compile(r"([MLHVAQlhvmz])([^MLHVAQlhvmz]*)")


class RobotMaker:
    """Builds a robot part by part."""

    def __init__(self, name: str = "rover") -> None:
        self.name = name
        self.links: dict[str, Link] = {}
        self.joints: dict[str, Joint] = {}

    def link(
        self, name: str, shape: Shape | None = None, pose: Pose = _HERE, **more: object
    ) -> None:
        color, mass = more.get("color"), more.get("mass")
        material = None if color is None else Material(f"paint {color}", (*color, 1.0))  # type: ignore[misc]
        bodies = () if shape is None else (Body(shape, pose, material),)
        inertial = None
        if mass is not None:
            inertial = Inertial(mass, Tensor(1, 0, 0, 1, 0, 1))  # type: ignore[arg-type]
        self.links[name] = Link(name, bodies, (), inertial)

    def joint(
        self, name: str, parent: str, child: str, type_: JointType = JointType.FIXED,
        at: Pose = _HERE, axis: Vector | None = None, limit: Limit | None = None,
    ) -> None:  # fmt: skip
        self.joints[name] = Joint(name, type_, parent, child, at, axis, limit)

    @property
    def robot(self) -> Description:
        return Description(self.name, self.links, self.joints)


def rover() -> Description:
    """A rover with two wheels, a caster, and a mast with what turns and what slides."""
    make = RobotMaker()
    make.link("base_link")
    make.link("chassis", Box((0.4, 0.3, 0.12)), Pose((0, 0, 0.06)), color=(1, 0.6, 0), mass=5)
    make.joint("base", "base_link", "chassis", at=Pose((0, 0, 0.08)))
    for side, y in (("left", 0.18), ("right", -0.18)):
        wheel = Pose((0, 0, 0), (pi / 2, 0, 0))
        make.link(f"{side}_wheel", Cylinder(0.08, 0.05), wheel, color=(0.1, 0.1, 0.1), mass=0.5)
        turns, at = JointType.CONTINUOUS, Pose((0.1, y, 0))
        make.joint(f"{side}_axle", "chassis", f"{side}_wheel", turns, at, (0, 1, 0))
    make.link("caster", Sphere(0.04))
    make.joint("caster_mount", "chassis", "caster", at=Pose((-0.15, 0, -0.04)))
    make.link("mast", Cylinder(0.015, 0.3), Pose((0, 0, 0.15)))
    make.joint("mast_mount", "chassis", "mast", at=Pose((-0.1, 0, 0.12)))
    make.link("head", Box((0.06, 0.12, 0.04)), color=(0.1, 0.2, 0.9))
    limit = Limit(-pi / 2, pi / 2, 1, 1)
    at = Pose((0, 0, 0.32), (0, 0.4, 0.5))
    make.joint("pan", "mast", "head", JointType.REVOLUTE, at, (0, 0, 1), limit)
    make.link("lens", Mesh("package://rover/meshes/lens.dae"))
    limit = Limit(0, 0.02, 1, 1)
    make.joint("zoom", "head", "lens", JointType.PRISMATIC, Pose((0.05, 0, 0)), (1, 0, 0), limit)
    return make.robot


def many_links(count: int, size: float = 1.0, seed: int = 3) -> Description:
    """A robot of links at random, some ten times as large as `size`, in metres."""
    chance = random.Random(seed)

    def vector(most: float) -> Vector:
        x, y, z = (chance.uniform(-most, most) for _ in range(3))
        return x, y, z

    make = RobotMaker("many")
    for at in range(count):
        wide, long = (size * chance.uniform(0.02, 0.3) for _ in range(2))
        shapes = (Box((wide, long, wide)), Cylinder(wide / 2, long), Sphere(wide / 2))
        color = tuple(chance.random() for _ in range(3))
        make.link(f"link_{at}", chance.choice(shapes), color=color if at % 3 else None)
        if at:
            parent = f"link_{chance.randrange(max(0, at - 8), at)}"
            pose = Pose(vector(0.3 * size), vector(pi))
            type_ = chance.choice(tuple(JointType))
            make.joint(f"joint_{at}", parent, f"link_{at}", type_, pose, vector(1.0))
    return make.robot


def shown(robot: Description, **more: object) -> GraphRobot:
    """Return a robot as a graph has it."""
    return GraphRobot(robot.name, "robot", None, False, Span(0, 1), robot)._replace(**more)


_lengths = st.floats(0.01, 2.0)
_angles = st.one_of(st.sampled_from((0.0, pi / 2, pi, -pi / 2)), st.floats(-4.0, 4.0))
_places = st.floats(-2.0, 2.0)
poses = st.builds(Pose, st.tuples(_places, _places, _places), st.tuples(_angles, _angles, _angles))
shapes = st.one_of(
    st.builds(Box, st.tuples(_lengths, _lengths, _lengths)),
    st.builds(Cylinder, _lengths, _lengths),
    st.builds(Sphere, _lengths),
)
_names = st.text(
    st.sampled_from("ab_<&>\"'/\\\n\x1b\u202eé漢🤖 "), min_size=1, max_size=9
)  # fmt: skip


@st.composite
def hostile_robots(draw: st.DrawFn) -> Description:
    """Return any robot: odd names, numbers without end, joints to nowhere, circles."""
    number = st.sampled_from((0.0, 1.0, -0.5, 1e-9, 1e12, -1e308, float("inf"), float("nan")))
    vector = st.tuples(number, number, number)
    pose = st.builds(Pose, vector, vector)
    shape = st.one_of(
        st.none(),
        st.builds(Box, vector),
        st.builds(Cylinder, number, number),
        st.builds(Sphere, number),
        st.builds(Mesh, _names, vector),
    )
    names = draw(st.lists(_names, max_size=6, unique=True))
    make = RobotMaker(draw(_names))
    for name in names:
        bodies = tuple(Body(draw(shape), draw(pose)) for _ in range(draw(st.integers(0, 2))))
        make.links[name] = Link(name, bodies[:1], bodies[1:])
    ends = st.sampled_from([*names, "nowhere"])
    for at in range(draw(st.integers(0, 6))):
        type_, limit = draw(st.sampled_from(JointType)), draw(st.builds(Limit, number, number))
        make.joint(f"{at}", draw(ends), draw(ends), type_, draw(pose), draw(vector), limit)
    return make.robot


class Drawn(NamedTuple):
    """What is drawn in a view: the corners of bodies by links, and names with their frames."""

    key: str
    bodies: dict[str, list[tuple[float, float]]]
    names: list[tuple[str, Frame]]
    leaders: list[list[tuple[float, float]]]


def views_of(root: ET.Element) -> Iterator[Drawn]:
    """Yield the views in a picture, in its own coordinates."""
    for group, left, top in _placed(root, 0.0, 0.0):
        if group.get("class") == "view":
            yield _view(group, left, top)


def _placed(
    element: ET.Element, left: float, top: float
) -> Iterator[tuple[ET.Element, float, float]]:
    moved = _TRANSLATE.search(element.get("transform", ""))
    if moved is not None:
        left, top = left + float(moved[1]), top + float(moved[2])
    yield element, left, top
    for child in element:
        yield from _placed(child, left, top)


def _view(group: ET.Element, left: float, top: float) -> Drawn:
    drawn = Drawn(group.get("data-view", ""), {}, [], [])
    for body in group.iter(f"{SVG}g"):
        if (body.get("class") or "").startswith("body"):
            name = body.findtext(f"{SVG}title") or ""
            points = drawn.bodies.setdefault(name, [])
            for part in body:
                points += [(x + left, y + top) for x, y in _points(part)]
    for text in group.iter(f"{SVG}text"):
        if text.get("class") == "name":
            x, y = float(text.get("x", 0)) + left, float(text.get("y", 0)) + top
            wide = text_width(text.text or "", 10.5)
            drawn.names.append((text.text or "", Frame(x, y - 7.5, x + wide, y + 2.0)))
    for path in group.iter(f"{SVG}path"):
        if path.get("class") == "lead":
            drawn.leaders.append([(x + left, y + top) for x, y in _points(path)])
    return drawn


def _points(element: ET.Element) -> Iterator[tuple[float, float]]:
    if element.tag == f"{SVG}circle":
        x, y, radius = (float(element.get(key, 0)) for key in ("cx", "cy", "r"))
        yield from ((x - radius, y), (x + radius, y), (x, y - radius), (x, y + radius))
    for command, written in _COMMAND.findall(element.get("d", "")):
        numbers = [float(each) for each in written.split()]
        if command in "ML":
            yield numbers[0], numbers[1]
        elif command == "A":
            yield numbers[5], numbers[6]
