"""What robots' files say, and what is wrong in them, as urdfdom takes it."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.diagnostics.severity import Severity
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
from plastron_tui.sources.urdf.reader import read_urdf

ROVER = """\
<?xml version="1.0"?>
<robot name="rover">
  <material name="blue"><color rgba="0 0 .8 1."/></material>
  <link name="base">
    <visual name="shell">
      <origin xyz="1 2 3"/>
      <geometry><box size=" 1  2 3 "/></geometry>
      <material name="blue"/>
    </visual>
    <visual>
      <geometry><mesh filename="package://a/b.stl"/></geometry>
      <material name=""><texture filename="wood.png"/></material>
    </visual>
    <collision><origin rpy="0 0 +1e-1"/><geometry><sphere radius="1"/></geometry></collision>
    <inertial>
      <mass value="2"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>
    </inertial>
    <unknown name="left alone"/>
  </link>
  <joint name="turn" type="revolute" extra="1">
    <parent link="base"/><child link="arm"/>
    <limit effort="1" velocity="2" upper="3"/>
    <dynamics friction="1"/>
    <mimic joint="lift" offset="1"/>
    <safety_controller k_velocity="1"/>
  </joint>
  <joint name="lift" type="fixed">
    <parent link="arm"/><child link="tip"/><axis xyz="0 0 0"/>
  </joint>
  <link name="arm"><visual><geometry><cylinder length="1" radius="2"/></geometry></visual></link>
  <link name="tip"/>
  <transmission name="t"><joint name="turn"/><link name="tip"/></transmission>
  <gazebo reference="tip"><joint name="other" type="strange"/><link name="tip"/></gazebo>
</robot>
"""


def test_all_that_a_file_says_is_read() -> None:
    base = Link(
        "base",
        (
            Body(Box((1, 2, 3)), Pose((1, 2, 3)), Material("blue"), "shell"),
            Body(Mesh("package://a/b.stl"), material=Material("", texture="wood.png")),
        ),
        (Body(Sphere(1), Pose(rotation=(0, 0, 0.1))),),
        Inertial(2, Tensor(1, 0, 0, 1, 0, 1)),
    )
    turn = Joint(
        "turn",
        JointType.REVOLUTE,
        "base",
        "arm",
        limit=Limit(0, 3, 1, 2),
        dynamics=Dynamics(0, 1),
        mimic=Mimic("lift", 1, 1),
    )
    lift = Joint("lift", JointType.FIXED, "arm", "tip", axis=(0, 0, 0))
    read = read_urdf(ROVER.encode())
    assert read.description == Description(
        "rover",
        {
            "base": base,
            "arm": Link("arm", (Body(Cylinder(2, 1)),)),
            "tip": Link("tip"),
        },
        {"turn": turn, "lift": lift},
        {"blue": Material("blue", (0, 0, 0.8, 1))},
    )
    assert read.diagnostics == ()
    assert ROVER[read.places.links["arm"].span.start :].startswith('<link name="arm">')
    assert ROVER[read.places.joints["turn"].span.start :].startswith('<joint name="turn"')
    assert ROVER[read.places.materials["blue"].span.start :].startswith('<material name="blue"')


SPHERE = '<geometry><sphere radius="1"/></geometry>'
BLUE = '<material name="blue"/>'
INERTIA = '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>'


def seen(inner: str) -> str:
    return f'<link name="a"><visual>{inner}</visual></link>'


def sphere(radius: str) -> str:
    return seen(f'<geometry><sphere radius="{radius}"/></geometry>')


def inertial(inner: str) -> str:
    return f'<link name="a"><inertial>{inner}</inertial></link>'


def joint(inner: str, head: str = 'name="j" type="continuous"') -> str:
    ends = '<parent link="a"/><child link="b"/>'
    return f'<link name="a"/><link name="b"/><joint {head}>{ends}{inner}</joint>'


REFUSED = {
    "<link/>": ("link", "`<link>` has no `name`"),
    '<link name=" "/>': ('name=" "', "`name` is empty"),
    '<link name="a"/><link name="a"/>': ("a", "a link `a` is there already"),
    seen(""): ("visual", "`<visual>` has no `<geometry>`"),
    seen("<geometry/>"): ("geometry", "the geometry is empty"),
    seen("<geometry><cone/></geometry>"): ("cone", "`<cone>` is no shape"),
    sphere("1,5"): ("1,5", "`1,5` in `radius` is no number"),
    sphere("nan"): ("nan", "is no number"),
    sphere("inf"): ("inf", "is no number"),
    sphere("0x10"): ("0x10", "is no number"),
    sphere("1e999"): ("1e999", "is no number"),
    sphere("\u0661"): ("\u0661", "is no number"),
    sphere("${r}"): ("${r}", "is no number"),
    seen('<geometry><box size="1 2"/></geometry>'): ("1 2", "`size` has 2 numbers, and 3"),
    seen("<geometry><mesh/></geometry>"): ("mesh", "`<mesh>` has no `filename`"),
    seen(f"{SPHERE}<material/>"): ("material", "the material has no name"),
    seen(SPHERE + BLUE): ("blue", "no material is called `blue`"),
    seen(f'{SPHERE}<material name="x"><color rgba="1 1 1 2"/></material>'): (
        "1 1 1 2",
        "from 0 to 1",
    ),
    '<material name="x"/><link name="a"/>': ("material", "neither a colour nor a texture"),
    inertial(INERTIA): ("inertial", "`<inertial>` has no `<mass>`"),
    inertial('<mass value="1"/><inertia ixx="1"/>'): ("inertia", "`<inertia>` has no `ixy`"),
    joint("", 'type="fixed"'): ("joint", "`<joint>` has no `name`"),
    joint("", 'name="j"'): ("joint", "`<joint>` has no `type`"),
    joint("", 'name="j" type="fix"'): ("fix", "`fix` is no joint type"),
    joint("", 'name="j" type="revolute"'): ("joint", "revolute needs a `<limit>`"),
    joint('<limit effort="1"/>'): ("limit", "`<limit>` has no `velocity`"),
    joint('<axis xyz="up"/>'): ("up", "is no number"),
    joint("<dynamics/>"): ("dynamics", "neither damping nor friction"),
    joint("<mimic/>"): ("mimic", "`<mimic>` has no `joint`"),
    joint('<origin xyz=""/>'): ('xyz=""', "`xyz` has 0 numbers"),
    '<link name="a"/><joint name="j" type="fixed"><parent link="a"/></joint>': (
        "joint",
        "`<joint>` has no `<child>`",
    ),
}


@pytest.mark.parametrize("inner", REFUSED)
def test_what_is_wrong_is_told_at_its_place_and_the_rest_is_read(inner: str) -> None:
    text = f'<robot name="r">{inner}<link name="last"/></robot>'.encode()
    read = read_urdf(text, Path("r.urdf"))
    assert read.description is not None
    assert "last" in read.description.links
    (found, *_) = read.diagnostics
    where, message = REFUSED[inner]
    assert message in found.message
    assert found.severity is Severity.ERROR
    assert found.file == Path("r.urdf")
    assert found.span is not None
    quoted = text[found.span.start : found.span.end].decode()
    assert quoted == where or (quoted == "" and where == 'xyz=""')


TAKEN = (
    sphere("1e-999"),
    sphere("+.5e+1"),
    sphere("5."),
    seen(f'{SPHERE}<material name=""><color rgba="1 1 1 1"/></material>'),
    seen(SPHERE + BLUE) + '<material name="blue"><color rgba="1 1 1 1"/></material>',
    joint('<axis xyz="nonsense"/>', 'name="j" type="fixed"'),
    joint("<limit effort='1' velocity='1'/>", 'name="j" type="prismatic"'),
)


@pytest.mark.parametrize("inner", TAKEN)
def test_what_urdfdom_takes_is_no_mistake(inner: str) -> None:
    assert read_urdf(f'<robot name="r">{inner}</robot>'.encode()).diagnostics == ()


@pytest.mark.parametrize("blank", ["\t", "\n", "\r\n"])
def test_blanks_that_only_other_tools_take_are_told(blank: str) -> None:
    inner = seen(f"<origin xyz='0 1{blank}2'/>{SPHERE}")
    read = read_urdf(f'<robot name="r">{inner}</robot>'.encode())
    (found,) = read.diagnostics
    assert found.message == "`xyz` has a tab or a line break behind a number"
    assert read.description is not None
    assert read.description.links["a"].visuals[0].pose.position == (0, 1, 2)


def test_a_blank_behind_a_number_is_told() -> None:
    read = read_urdf(f'<robot name="r">{sphere("0.5 ")}</robot>'.encode())
    (found,) = read.diagnostics
    assert found.message == "`radius` has a blank behind the number, which urdfdom does not take"
    assert found.severity is Severity.WARNING
    assert read.description is not None
    assert read.description.links["a"].visuals[0].shape == Sphere(0.5)


def test_a_colour_that_does_not_count_is_told() -> None:
    red = seen(SPHERE + '<material name="m"><color rgba="1 0 0 1"/></material>')
    green = red.replace("1 0 0", "0 1 0").replace('"a"', '"b"')
    text = f'<robot name="r">{red}{green}</robot>'
    (found,) = read_urdf(text.encode()).diagnostics
    assert found.message == "another material is called `m`, and is the one that counts"
    assert found.severity is Severity.WARNING


def test_what_is_odd_is_told_and_a_zero_is_a_zero() -> None:
    odd = '<mass value="-1"/>' + INERTIA
    text = inertial(odd) + joint('<mimic joint="k" multiplier="0"/>').replace(
        '<link name="a"/>', ""
    )
    read = read_urdf(f'<robot name="r">{text}</robot>'.encode())
    assert [each.message for each in read.diagnostics] == ["the mass is negative"]
    assert read.description is not None
    assert read.description.joints["j"].mimic == Mimic("k", 0)


def test_another_file_is_no_robot() -> None:
    read = read_urdf(b"<sdf/>")
    assert read.description is None
    assert [each.message for each in read.diagnostics] == [
        "the outermost element of a robot's file is `<robot>`, and this is `<sdf>`"
    ]


def test_what_macros_compute_is_no_mistake() -> None:
    head = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro">'
    painted = sphere("${r}").replace("</visual>", f"{BLUE}</visual>")
    text = f"{head}<xacro:property name='r' value='1'/>{painted}</robot>"
    read = read_urdf(text.encode())
    assert read.diagnostics == ()
    assert read.description is not None
    assert read.description.links["a"].visuals == (Body(None, material=Material("blue")),)
