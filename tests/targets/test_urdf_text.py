"""The text of robots' files, and what other tools read in it."""

from __future__ import annotations

import math
import random
import subprocess
import sysconfig
from pathlib import Path

import pytest
from machine import examples

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
from plastron_tui.targets.robots.urdf import write_urdf

RED = Material("red", (1, 0, 0, 1))
WOOD = Material("wood", texture="package://demo/wood.png")

ARM = Description(
    "arm-2",
    {
        "upper.arm": Link("upper.arm", (Body(Cylinder(0.05, 0.5), Pose((0, 0, 0.25)), RED),)),
        "base": Link("base"),
        "hand": Link(
            "hand",
            (
                Body(Mesh("package://demo/a&b.stl", (0.001, 0.001, 0.001)), material=RED),
                Body(Box((1, 1, 1)), material=WOOD, name="box"),
            ),
            (Body(Sphere(0.1), Pose(rotation=(math.pi / 2, 0, 0))),),
            Inertial(0.5, Tensor(0.1, 0, 0, 0.1, 0, 1 / 3)),
        ),
    },
    {
        "wrist": Joint(
            "wrist",
            JointType.CONTINUOUS,
            "upper.arm",
            "hand",
            limit=Limit(effort=1, velocity=2),
            mimic=Mimic("shoulder", -1),
        ),
        "shoulder": Joint(
            "shoulder",
            JointType.REVOLUTE,
            "base",
            "upper.arm",
            Pose((0, 0, 0.1)),
            (0, 1, 0),
            Limit(0, math.pi, 10, 1),
            Dynamics(0.1),
        ),
    },
)

TEXT = """\
<?xml version="1.0"?>
<robot name="arm-2">
  <material name="red">
    <color rgba="1 0 0 1"/>
  </material>
  <material name="wood">
    <texture filename="package://demo/wood.png"/>
  </material>

  <link name="base"/>

  <joint name="shoulder" type="revolute">
    <origin xyz="0 0 0.1"/>
    <parent link="base"/>
    <child link="upper.arm"/>
    <axis xyz="0 1 0"/>
    <limit lower="0" upper="3.141592654" effort="10" velocity="1"/>
    <dynamics damping="0.1" friction="0"/>
  </joint>

  <link name="upper.arm">
    <visual>
      <origin xyz="0 0 0.25"/>
      <geometry>
        <cylinder radius="0.05" length="0.5"/>
      </geometry>
      <material name="red"/>
    </visual>
  </link>

  <joint name="wrist" type="continuous">
    <parent link="upper.arm"/>
    <child link="hand"/>
    <limit effort="1" velocity="2"/>
    <mimic joint="shoulder" multiplier="-1"/>
  </joint>

  <link name="hand">
    <visual>
      <geometry>
        <mesh filename="package://demo/a&amp;b.stl" scale="0.001 0.001 0.001"/>
      </geometry>
      <material name="red"/>
    </visual>
    <visual name="box">
      <geometry>
        <box size="1 1 1"/>
      </geometry>
      <material name="wood"/>
    </visual>
    <collision>
      <origin xyz="0 0 0" rpy="1.570796327 0 0"/>
      <geometry>
        <sphere radius="0.1"/>
      </geometry>
    </collision>
    <inertial>
      <mass value="0.5"/>
      <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.3333333333"/>
    </inertial>
  </link>
</robot>
"""


def test_a_robot_is_written_as_people_write_it() -> None:
    assert write_urdf(ARM).decode() == TEXT


def test_a_robot_without_materials_begins_with_its_links() -> None:
    text = write_urdf(Description("r", {"a": Link("a")}))
    assert text == b'<?xml version="1.0"?>\n<robot name="r">\n  <link name="a"/>\n</robot>\n'


def test_two_colours_of_one_name_and_those_without_one_stay_in_their_links() -> None:
    def seen(name: str, *materials: Material) -> Link:
        return Link(name, tuple(Body(Sphere(1), material=each) for each in materials))

    blue, other = Material("m", (0, 0, 1, 1)), Material("m", (0, 1, 0, 1))
    one, two = Material("", (0, 0, 0, 1)), Material("", (1, 1, 1, 1))
    robot = Description("r", {"a": seen("a", blue, other, one), "b": seen("b", blue, two)})
    text = write_urdf(robot).decode()
    assert text.count('<material name="m"/>') == 2
    assert text.count('<material name="">') == 2
    assert text.count('<color rgba="0 1 0 1"/>') == 1


@pytest.mark.long
def test_other_tools_read_what_is_written(tmp_path: Path) -> None:
    yourdfpy = pytest.importorskip("yourdfpy")
    checkers = [
        path
        for path in (Path("/usr/bin/check_urdf"), Path(sysconfig.get_path("scripts"), "check_urdf"))
        if path.exists()
    ]
    assert checkers
    choice = random.Random(15)
    for _ in range(examples(20)):
        robot = tree(choice)
        path = tmp_path / "robot.urdf"
        path.write_bytes(write_urdf(robot))
        for checker in checkers:
            done = subprocess.run([checker, path], capture_output=True, text=True, check=False)
            assert done.returncode == 0, done.stderr
            assert "rror" not in done.stderr, done.stderr
        other = yourdfpy.URDF.load(
            str(path), build_scene_graph=False, load_meshes=False, load_collision_meshes=False
        ).robot
        assert [each.name for each in other.links] != []
        assert {each.name for each in other.links} == set(robot.links)
        assert {(each.name, each.type, each.parent, each.child) for each in other.joints} == {
            (each.name, each.type.value, each.parent, each.child) for each in robot.joints.values()
        }


def tree(choice: random.Random) -> Description:
    """Return a robot of a few links that has something of everything."""
    links, joints = {"l0": Link("l0")}, {}
    for at in range(1, choice.randint(2, 12)):
        name, parent = f"l{at}", f"l{choice.randrange(at)}"
        links[name] = choice.choice(list(ARM.links.values()))._replace(name=name)
        type_ = choice.choice(list(JointType))
        limit = Limit(-1, 1, 10, 1) if type_.is_limited else None
        mimic = Mimic("j1", 2, 0.5) if at > 1 and choice.random() < 0.3 else None
        pose = Pose((choice.random(), 0, 0), (0, 0, choice.random()))
        axis = (0, 0, 1) if choice.random() < 0.5 else None
        joints[f"j{at}"] = Joint(f"j{at}", type_, parent, name, pose, axis, limit, None, mimic)
    return Description("tree", links, joints)
