"""What sentences about robots make of a robot."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import pytest
from robots_run import (
    BODY,
    BOX,
    FILE,
    LOAD,
    MADE,
    TENSOR,
    expanded,
    robot,
    run,
    source,
    with_macros,
)

from plastron_tui.ros.robots.description import (
    Body,
    Box,
    Cylinder,
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
)
from plastron_tui.ros.robots.inertia import tensor_of

RED = Material("red", (1.0, 0.0, 0.0, 1.0))


def whole(shape: object, pose: Pose | None = None, **more: object) -> Link:
    body = Body(shape, pose or Pose())  # type: ignore[arg-type]
    return Link("a", (body._replace(**more),), (body,))


@pytest.mark.parametrize(
    ("said", "link"),
    [
        ("", Link("a")),
        ("shaped box 1, 2, 3", whole(Box((1.0, 2.0, 3.0)))),
        ("shaped box x=1, z=3, y=2", whole(Box((1.0, 2.0, 3.0)))),
        ("shaped cylinder 0.1, 2", whole(Cylinder(0.1, 2.0))),
        ("shaped cylinder length=2, radius=0.1", whole(Cylinder(0.1, 2.0))),
        ("shaped sphere 0.1", whole(Sphere(0.1))),
        ('shaped mesh "a.stl"', whole(Mesh("a.stl"))),
        ('shaped mesh "a.stl", scale=0.001', whole(Mesh("a.stl", (0.001,) * 3))),
        ('shaped mesh "a.stl", (1, -1, 2)', whole(Mesh("a.stl", (1.0, -1.0, 2.0)))),
        ("shaped sphere 1 painted red", whole(Sphere(1.0), material=RED)),
        (
            'shaped sphere 1 painted "#00f8"',
            whole(Sphere(1.0), material=Material("color_00f8", (0.0, 0.0, 1.0, 0.533))),
        ),
        (
            "shaped sphere 1 at 1, 2, -3 turned 90, 0, -180 deg",
            whole(Sphere(1.0), Pose((1.0, 2.0, -3.0), (pi / 2, 0.0, -pi))),
        ),
        ("shaped sphere 1 turned 1, 2, 3 rad", whole(Sphere(1.0), Pose(rotation=(1.0, 2.0, 3.0)))),
    ],
)
def test_a_link_is_what_is_said_of_it(said: str, link: Link) -> None:
    assert robot(f"{MADE}r has_link 'a' {said}\n").description.links == {"a": link}


def test_a_link_that_weighs_something_has_the_inertia_of_its_shape() -> None:
    found = robot(f"{MADE}r has_link 'a' shaped sphere 0.1 at 0, 0, 1 weighing 2.5\n")
    tensor = tensor_of(Sphere(0.1), 2.5)
    assert tensor is not None
    assert found.description.links["a"].inertial == Inertial(2.5, tensor, Pose((0.0, 0.0, 1.0)))


TWO = f"{MADE}r has_link 'a'\nr has_link 'b'\nr has_link 'c'\n"
J = Joint("j", JointType.CONTINUOUS, "a", "b")
JOINT = "r has_joint 'j' of joint_type continuous from 'a' to 'b'"


@pytest.mark.parametrize(
    ("lines", "joints"),
    [
        (JOINT, [J]),
        (
            f"{JOINT} at 0, 0, 1 turned 0, 0, 90 deg",
            [J._replace(pose=Pose((0.0, 0.0, 1.0), (0.0, 0.0, pi / 2)))],
        ),
        (f"{JOINT} mimicking none", [J]),
        ("r has_joint 'j' from 'a' to 'b' of joint_type continuous", [J]),
        (f"{JOINT} with axis 0, 0, 2", [J._replace(axis=(0.0, 0.0, 2.0))]),
        (
            f"{JOINT}\nr limits_joint 'j' with effort 5 and velocity 2",
            [J._replace(limit=Limit(0.0, 0.0, 5.0, 2.0))],
        ),
        (
            f"{JOINT}\nr limits_joint 'j' with damping 5 and friction 2",
            [J._replace(dynamics=Dynamics(5.0, 2.0))],
        ),
        (
            f"{JOINT.replace('continuous', 'revolute')}\n"
            "r limits_joint 'j' between -90 and 90 deg with effort 5 and velocity 2",
            [J._replace(type=JointType.REVOLUTE, limit=Limit(-pi / 2, pi / 2, 5.0, 2.0))],
        ),
        (
            f"{JOINT.replace('continuous', 'prismatic')}\n"
            "r limits_joint 'j' between 0 and 0.5 m with effort 5 and velocity 2",
            [J._replace(type=JointType.PRISMATIC, limit=Limit(0.0, 0.5, 5.0, 2.0))],
        ),
        (
            f"{JOINT}\n"
            "r has_joint 'k' of joint_type continuous from 'a' to 'c' mimicking 'j' times -2",
            [J, J._replace(name="k", child="c", mimic=Mimic("j", -2.0))],
        ),
        (f"{JOINT}\nr no_longer_has_joint 'j'", []),
        (f"{JOINT}\nr no_longer_has_joint 'j'\n{JOINT}", [J]),
    ],
)
def test_a_joint_is_what_is_said_of_it(lines: str, joints: list[Joint]) -> None:
    found = robot(f"{TWO}{lines}\n").description.joints
    assert list(found.values()) == joints
    assert list(found) == [each.name for each in joints]


ARM = FILE.links["arm"]
TURN, SLIDE = FILE.joints["turn"], FILE.joints["slide"]
LARGE = tensor_of(Box((1.0, 1.0, 1.0)), 5.0)
assert LARGE is not None


@pytest.mark.parametrize(
    ("line", "links"),
    [
        (
            "has_link 'arm' weighing 10",
            [ARM._replace(inertial=Inertial(10.0, type(TENSOR)(0.6, 0.0, 0.0, 0.6, 0.0, 0.6)))],
        ),
        (
            "has_link 'arm' shaped box 1, 1, 1",
            [
                Link(
                    "arm",
                    (BODY._replace(shape=Box((1.0, 1.0, 1.0))),),
                    (Body(Box((1.0, 1.0, 1.0))),),
                    Inertial(5.0, LARGE),
                )
            ],
        ),
        ("has_link 'arm' painted red", [ARM._replace(visuals=(BODY._replace(material=RED),))]),
        ("has_link 'hand' painted red", [Link("hand", (BODY._replace(material=RED),) * 2)]),
        (
            "has_link 'base' shaped sphere 1 painted blue",
            [Link("base", (Body(Sphere(1.0), material=Material("blue")),), (Body(Sphere(1.0)),))],
        ),
        ("has_link 'arm' painted blue", []),
        ("has_link 'arm' painted none", [ARM._replace(visuals=(Body(BOX),))]),
        (
            "has_link 'base' shaped sphere 1 painted none",
            [Link("base", (Body(Sphere(1.0)),), (Body(Sphere(1.0)),))],
        ),
    ],
)
def test_a_loaded_link_changes_as_is_said(line: str, links: list[Link]) -> None:
    found = robot(f"{LOAD}r {line}\n")
    assert found.source is not None and found.source.description == FILE
    assert found.description.links == {**FILE.links, **{each.name: each for each in links}}


@pytest.mark.parametrize(
    ("line", "joint"),
    [
        (
            "limits_joint 'turn' between -2 and 2 rad",
            TURN._replace(limit=Limit(-2.0, 2.0, 5.0, 2.0)),
        ),
        (
            "limits_joint 'turn' with effort 7 and velocity 8",
            TURN._replace(limit=Limit(-1.0, 1.0, 7.0, 8.0)),
        ),
        ("limits_joint 'slide' between 0 and 1 m", SLIDE),
        (
            "has_joint 'turn' of joint_type continuous from 'base' to 'arm'",
            TURN._replace(type=JointType.CONTINUOUS, limit=Limit(0.0, 0.0, 5.0, 2.0)),
        ),
        ("has_joint 'turn' at 1, 0, 0", TURN._replace(pose=Pose((1.0, 0.0, 0.0)))),
        ("has_joint 'turn' with axis 0, 0, 1", TURN._replace(axis=(0.0, 0.0, 1.0))),
        ("has_joint 'turn' mimicking 'slide'", TURN._replace(mimic=Mimic("slide"))),
        ("has_joint 'turn' mimicking none", TURN),
        ("has_joint 'slide' from 'arm' to 'tip'", SLIDE._replace(parent="arm")),
        ("has_joint 'slide' of joint_type fixed", SLIDE._replace(type=JointType.FIXED, limit=None)),
        (
            "has_joint 'slide' of joint_type fixed from 'arm' to 'tip' at 1, 0, 0",
            Joint("slide", JointType.FIXED, "arm", "tip", Pose((1.0, 0.0, 0.0))),
        ),
    ],
)
def test_a_loaded_joint_changes_as_is_said(line: str, joint: Joint) -> None:
    found = robot(f"{LOAD}r {line}\n").description
    assert found.joints == {**FILE.joints, joint.name: joint}
    assert found.links == FILE.links


def test_a_mimic_keeps_what_is_not_said() -> None:
    mimicking = TURN._replace(mimic=Mimic("slide", 2.0, 0.5))
    loaded = robot(LOAD).source
    assert loaded is not None
    described = loaded.description
    changed = type(described)(
        "loaded", described.links, {**described.joints, "turn": mimicking}, described.materials
    )
    line = "r has_joint 'turn' of joint_type revolute from 'base' to 'arm' mimicking 'slide'"
    kept = robot(f"{LOAD}{line}\n", loaded._replace(description=changed)).description
    assert kept.joints["turn"].mimic == Mimic("slide", 2.0, 0.5)
    times = robot(f"{LOAD}{line} times 3\n", loaded._replace(description=changed)).description
    assert times.joints["turn"].mimic == Mimic("slide", 3.0, 0.5)
    line = "r has_joint 'turn' mimicking none at 1, 0, 0"
    free = robot(f"{LOAD}{line}\n", loaded._replace(description=changed)).description
    assert free.joints["turn"] == TURN._replace(pose=Pose((1.0, 0.0, 0.0)))


def test_a_colour_is_what_the_file_means_by_its_name() -> None:
    red = Material("red", (0.5, 0.0, 0.0, 1.0))
    painted = replace(FILE, links={**FILE.links, "base": whole(BOX, material=red)})
    found = robot(f"{LOAD}r has_link 'arm' painted red\n", source(painted))
    assert found.description.links["arm"].visuals[0].material == red


def test_what_is_generated_is_the_robot_as_it_was_then() -> None:
    found = run(f"{MADE}r has_link 'a'\ngenerate_robot r\nr has_link 'b'\n")
    (written,) = found.workspace.written_robots
    assert list(written.robot.description.links) == ["a"]
    assert list(found.workspace.robots["r"].description.links) == ["a", "b"]


def test_where_a_written_robot_is_spoken_of_stays() -> None:
    later = "r has_joint 'turn' at 0, 0, 1\nr no_longer_has_joint 'slide'\n"
    (written,) = run(f"{LOAD}generate_robot r\n{later}").workspace.written_robots
    assert (written.robot.joints, written.robot.taken) == ({}, {})


def test_no_statement_changes_what_was_loaded() -> None:
    found = robot(f"{LOAD}r no_longer_has_joint 'slide'\nr no_longer_has_link 'tip'\n")
    assert "tip" not in found.description.links
    assert "slide" not in found.description.joints
    assert found.source is not None and found.source.description == FILE
    assert len(FILE.links) == 4


def test_what_macros_make_can_be_relied_on() -> None:
    lines = "r has_link 'lens'\nr has_joint 'l' of joint_type fixed from 'camera' to 'lens'\n"
    found = robot(f"{LOAD}{lines}generate_robot r\n", with_macros(expanded()))
    assert list(found.description.links) == [*FILE.links, "lens"]
    assert list(found.shown.links) == [*FILE.links, "camera", "lens"]
    # Of macros that are not expanded nobody knows what they make.
    assert "l" in robot(f"{LOAD}{lines}generate_robot r\n", with_macros(None)).description.joints
