"""Random robots: a tree of links, with everything that URDF says of them."""

from __future__ import annotations

from collections.abc import Sequence

from hypothesis import strategies as st

from plastron_tui.ros.robots.description import (
    Body,
    Box,
    Cylinder,
    Description,
    Dynamics,
    Inertial,
    Joint,
    JointType,
    Limit,
    Link,
    Material,
    Mesh,
    Mimic,
    Pose,
    Sphere,
    Tensor,
)

NAMES = ("base", "arm.left", "wheel_1", "a&b<c", 'the "head"', "élan", "x")
NUMBERS = (0.0, 0.0, 1.0, -1.0, 0.1, 1e-6, 1.570796327, 123.25, 2e10)

_numbers = st.sampled_from(NUMBERS)
_lengths = st.sampled_from((0.05, 1.0, 0.3))
_vectors = st.tuples(_numbers, _numbers, _numbers)
_sizes = st.tuples(_lengths, _lengths, _lengths)
_poses = st.one_of(st.just(Pose()), st.builds(Pose, _vectors, _vectors))
_uris = st.sampled_from(("package://demo/meshes/a b.stl", "file:///a.dae", "a'\"&.obj"))
_shapes = st.one_of(
    st.builds(Box, _sizes),
    st.builds(Cylinder, _lengths, _lengths),
    st.builds(Sphere, _lengths),
    st.builds(Mesh, _uris, st.one_of(st.just((1.0, 1.0, 1.0)), _sizes)),
)
_shares = st.sampled_from((0.0, 0.25, 1.0))
_colors = st.tuples(_shares, _shares, _shares, _shares)
_textures = st.sampled_from((None, None, "package://demo/wood.png"))
_inertials = st.one_of(
    st.none(), st.builds(Inertial, _lengths, st.builds(Tensor, *[_numbers] * 6), _poses)
)
_material_names = st.lists(st.sampled_from(("blue", "grey.2", "r&d")), unique=True)
_names = st.lists(st.sampled_from(NAMES), min_size=1, unique=True)
_types = st.sampled_from(tuple(JointType))
_limits = st.builds(Limit, _numbers, _numbers, _lengths, _lengths)
_dynamics = st.one_of(st.none(), st.builds(Dynamics, _lengths, _numbers))


@st.composite
def robots(draw: st.DrawFn) -> Description:
    """Return a robot whose parts are in the order in which they are written."""
    materials = {
        name: Material(name, draw(_colors), draw(_textures)) for name in draw(_material_names)
    }
    names = draw(_names)
    links = {name: _link(draw, name, list(materials)) for name in names}
    joints: dict[str, Joint] = {}
    for at in range(1, len(names)):
        parent = names[draw(st.integers(0, at - 1))]
        joint = _joint(draw, f"to_{names[at]}", parent, names[at], list(joints))
        joints[joint.name] = joint
    return Description(draw(st.sampled_from(("rover", "arm-2"))), links, joints, materials)


@st.composite
def variations(draw: st.DrawFn, robot: Description) -> Description:
    """Return a robot in which each joint that stays holds what it held before."""
    materials = {
        name: Material(name, draw(_colors), draw(_textures)) if draw(st.booleans()) else material
        for name, material in robot.materials.items()
    }
    links: dict[str, Link] = {}
    joints: dict[str, Joint] = {}
    held = {joint.child: joint for joint in robot.joints.values()}
    for name, link in robot.links.items():
        joint = held.get(name)
        if joint is not None:
            goes = draw(st.integers(0, 4)) == 0
            if goes or joint.parent not in links:
                continue
            new = _joint(draw, joint.name, joint.parent, name, list(joints))
            joints[joint.name] = new if draw(st.booleans()) else joint
        links[name] = _link(draw, name, list(materials)) if draw(st.booleans()) else link
    for name in draw(st.lists(st.sampled_from(("new", "more")), unique=True)):
        parent = draw(st.sampled_from(list(links)))
        joints[f"to_{name}"] = _joint(draw, f"to_{name}", parent, name, list(joints))
        links[name] = _link(draw, name, list(materials))
    return Description(robot.name, links, joints, materials)


def _link(draw: st.DrawFn, name: str, materials: Sequence[str]) -> Link:
    names = st.sampled_from((None, *materials))
    visuals = []
    for body in draw(st.lists(_bodies(), max_size=2)):
        meant = draw(names)
        visuals.append(body._replace(material=None if meant is None else Material(meant)))
    collisions = draw(st.lists(_bodies(), max_size=2))
    return Link(name, tuple(visuals), tuple(collisions), draw(_inertials))


def _bodies() -> st.SearchStrategy[Body]:
    return st.builds(Body, _shapes, _poses, st.none(), st.sampled_from(("", "", "shell", "a > b")))


def _joint(draw: st.DrawFn, name: str, parent: str, child: str, others: Sequence[str]) -> Joint:
    type_ = draw(_types)
    limit = draw(_limits if type_.is_limited else st.one_of(st.none(), _limits))
    mimic = None
    follows = draw(st.booleans())
    if others and follows:
        mimic = Mimic(draw(st.sampled_from(others)), draw(_numbers), draw(_numbers))
    axis = draw(st.one_of(st.none(), _vectors))
    return Joint(name, type_, parent, child, draw(_poses), axis, limit, draw(_dynamics), mimic)
