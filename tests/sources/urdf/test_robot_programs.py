"""Robots that are written as programs: what is said is the robot's, and can be read."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from machine import examples
from random_robots import robots

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.language import Document, lower
from plastron_tui.model.robot_program import program_of_robot
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
    Mimic,
    Pose,
    Sphere,
    Tensor,
)
from plastron_tui.ros.robots.inertia import tensor_of
from plastron_tui.session import Session
from plastron_tui.sources.urdf.equality import same_robot
from plastron_tui.sources.urdf.reader import read_urdf
from plastron_tui.targets.robots.urdf import write_urdf

TURNED = Pose((0, 0.1, 0), (1.570796327, 0, 0))
TENSOR = tensor_of(Box((0.1, 0.2, 0.3)), 2)
assert TENSOR is not None


def robot(link: Link, *joints: Joint) -> Description:
    others = {each.child: Link(each.child) for each in joints}
    return Description("r", {link.name: link, **others}, {each.name: each for each in joints})


def same(shape: Box | Cylinder | Sphere, material: Material | None = None) -> Link:
    body = Body(shape, TURNED)
    return Link("a", (body._replace(material=material),), (body,))


WHOLE = [
    robot(Link("a")),
    robot(same(Box((0.1, 0.2, 0.3)))),
    robot(same(Sphere(0.1), Material("red", (1, 0, 0, 1)))),
    robot(same(Cylinder(0.1, 0.05), Material("color_30ff4080", (0.188, 1, 0.251, 0.502)))),
    robot(same(Box((0.1, 0.2, 0.3)))._replace(inertial=Inertial(2, TENSOR, TURNED))),
    robot(
        Link("a"),
        Joint("j", JointType.REVOLUTE, "a", "b", TURNED, (0, 1, 0), Limit(-1.5, 0.5, 20, 1.5)),
        Joint("k", JointType.CONTINUOUS, "b", "c", mimic=Mimic("j", 2)),
        Joint("s", JointType.PRISMATIC, "c", "d", axis=(0, 0, 1), limit=Limit(0, 0.5, 1, 1)),
    ),
]


@pytest.mark.parametrize("wanted", WHOLE)
def test_what_a_program_can_say_comes_back(wanted: Description, tmp_path: Path) -> None:
    program = program_of_robot(wanted, "r")
    assert "//" not in program
    session = Session(program.encode(), tmp_path / "a.plastron", environ={})
    assert not [each for each in session.diagnostics if each.span is None]
    made = session.workspace.robots["r"].description
    written, again = (read_urdf(write_urdf(each)).description for each in (wanted, made))
    assert written is not None
    assert again is not None
    assert same_robot(written, again)


@pytest.mark.parametrize(
    ("link", "told"),
    [
        (Link("a", (Body(Sphere(1)), Body(Sphere(2)))), "what is seen of it are 2 shapes"),
        (Link("a", (Body(Sphere(1)),)), "it does not collide"),
        (Link("a", (Body(Sphere(1)),), (Body(Sphere(2)),)), "what collides is something else"),
        (Link("a", (), (Body(Sphere(1)),)), "nothing is seen of it"),
        (Link("a", inertial=Inertial(1, TENSOR)), "it weighs 1 kg, and has no shape"),
        (
            Link("a", (Body(Sphere(1)),), (Body(Sphere(1)),), Inertial(1, TENSOR)),
            "its inertia is another one than that of its shape",
        ),
        (
            Link("a", (Body(Sphere(1), material=Material("m", None, "wood.png")),)),
            "its material is one that a program has no words for",
        ),
        (Link("a", (Body(Mesh("a.stl")),)), "it does not collide"),
        (Link("the 'head'"), "a link is called `the 'head'`, which no program can say"),
    ],
)
def test_what_no_program_says_is_a_comment(link: Link, told: str) -> None:
    comments = [x for x in program_of_robot(robot(link), "r").splitlines() if x.startswith("//")]
    assert any(told in each for each in comments), comments


def test_a_colour_is_that_of_the_first_material_of_its_name() -> None:
    red = Body(Sphere(1), material=Material("m", (1, 0, 0, 1)))
    links = {"a": Link("a", (red,)), "b": Link("b", (red._replace(material=Material("m")),))}
    lines = program_of_robot(Description("r", links), "r").splitlines()
    assert [each.rpartition(" ")[2] for each in lines if " has_link " in each] == ["red", "red"]


def test_an_inertia_of_two_digits_follows_from_its_shape() -> None:
    # 0.054, 0.042 and 0.021 for 0.054167, 0.041667 and 0.020833.
    shape = Box((0.1, 0.2, 0.3))
    exact = tensor_of(shape, 5)
    assert exact is not None
    rough = Tensor(*(round(each, 3) for each in exact))
    link = same(shape)._replace(inertial=Inertial(5, rough, TURNED))
    assert "//" not in program_of_robot(robot(link), "r")


@pytest.mark.parametrize(
    ("wanted", "told"),
    [
        (robot(Link("a", (Body(Box((0.1, 0, 0.1))),))), "`y` is more than 0"),
        (
            robot(
                Link("a"),
                Joint("j", JointType.CONTINUOUS, "a", "b", limit=Limit(0, 0, -1, 1)),
            ),
            "`effort` is a number from 0",
        ),
        (
            robot(Link("a"), Joint("j", JointType.FIXED, "x", "b")),
            "has no link `x`",
        ),
        (
            robot(Link("a"), Joint("j", JointType.CONTINUOUS, "a", "b", mimic=Mimic("none"))),
            "it follows `none`, which does not move",
        ),
    ],
)
def test_what_is_wrong_in_a_file_is_a_comment(wanted: Description, told: str) -> None:
    def errors(text: bytes) -> list[Diagnostic]:
        return [each for each in Session(text, environ={}).diagnostics if each.severity == "error"]

    program = program_of_robot(wanted, "r", errors)
    assert any(told in line for line in program.splitlines() if line.startswith("//"))
    assert {each.code for each in errors(program.encode())} <= {"no-tree"}


@settings(max_examples=examples(60), deadline=None, suppress_health_check=list(HealthCheck))
@given(robots())
def test_a_program_of_any_robot_can_be_read(any_robot: Description) -> None:
    program = lower(Document(program_of_robot(any_robot, "x y").encode()))
    assert program.diagnostics == ()
