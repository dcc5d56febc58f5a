"""Words of URDF that no sentence speaks of: they are told, and never lost without a word."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import pi
from typing import Any

import pytest

from plastron_tui.diagnostics.severity import Severity
from plastron_tui.ros.robots.description import (
    Body,
    Box,
    Description,
    JointType,
    Limit,
    Link,
    Material,
    Pose,
    Sphere,
)
from plastron_tui.ros.robots.quaternions import angles_of, quaternion_of
from plastron_tui.ros.robots.transforms import rotation_matrix
from plastron_tui.sources.urdf.edits import UrdfEdit, edited
from plastron_tui.sources.urdf.reader import read_urdf

QUATERNION = 'quat_xyzw="0 0 1 0"'
LIMIT = '<limit lower="-1" upper="1" effort="1" velocity="1" acceleration="3" jerk="4"/>'
NEW = f"""\
<robot name="r" version="1.2">
  <link name="a"/>
  <link name="b">
    <visual><geometry><capsule radius="1" length="2"/></geometry></visual>
  </link>
  <joint name="j" type="revolute">
    <parent link="a"/>
    <child link="b"/>
    <origin {QUATERNION} xyz="1 0 0"/>
    <axis xyz="0 0 1"/>
    {LIMIT}
    <safety_controller k_velocity="1" soft_lower_limit="-0.9"/>
  </joint>
</robot>
"""

Change = Callable[[Description], Description]


def joint(**values: Any) -> Change:
    def change(robot: Description) -> Description:
        return replace(robot, joints={"j": robot.joints["j"]._replace(**values)})

    return change


def make(text: str, change: Change) -> UrdfEdit:
    before = read_urdf(text.encode()).description
    assert before is not None
    return edited(text.encode(), before, change(before))


def turned(roll: float, pitch: float, yaw: float) -> Change:
    return joint(pose=Pose((1, 0, 0), (roll, pitch, yaw)))


def shaped(robot: Description) -> Description:
    return replace(robot, links={**robot.links, "b": Link("b", (Body(Box((1, 2, 3))),))})


SAFETY = "`<safety_controller>` stays as it is in a joint that is"
EDITS: dict[str, tuple[Change, dict[str, str], list[str]]] = {
    "a turn": (turned(0, 0, -pi / 2), {'"0 0 1 0"': '"0 0 -0.707106781187 0.707106781187"'}, []),
    "a turn and a place": (
        joint(pose=Pose()),
        {f'{QUATERNION} xyz="1 0 0"': 'quat_xyzw="0 0 0 1" xyz="0 0 0"'},
        [],
    ),
    "limits": (
        joint(limit=Limit(-0.5, 1, 1, 1)),
        {'lower="-1"': 'lower="-0.5"'},
        ["`soft_lower_limit` of `<safety_controller>` stays -0.9, which is beyond the new limits"],
    ),
    "limits around what is safe": (joint(limit=Limit(-2, 1, 1, 1)), {'"-1"': '"-2"'}, []),
    "another type": (
        joint(type=JointType.CONTINUOUS, limit=None),
        {"revolute": "continuous", f"    {LIMIT}\n": ""},
        ['`acceleration="3"`, `jerk="4"` go with the `<limit>`', f"{SAFETY} continuous now"],
    ),
    "another shape": (
        shaped,
        {'<capsule radius="1" length="2"/>': '<box size="1 2 3"/>'},
        ["`<capsule>` goes, with all that it says"],
    ),
}


@pytest.mark.parametrize("name", EDITS)
def test_what_no_sentence_speaks_of_stays_or_is_told(name: str) -> None:
    change, places, told = EDITS[name]
    expected = NEW
    for old, new in places.items():
        assert old in expected
        expected = expected.replace(old, new)
    edit = make(NEW, change)
    assert edit.text is not None, edit.diagnostics
    assert edit.text.decode() == expected
    assert [each.message for each in edit.diagnostics] == told
    assert {each.severity for each in edit.diagnostics} <= {Severity.WARNING}


def test_a_quaternion_is_read_as_a_turn() -> None:
    read = read_urdf(NEW.encode())
    assert read.description is not None
    assert read.description.joints["j"].pose.rotation == (0, 0, round(pi, 10))
    edit = make(NEW, turned(0, 0, -pi))
    assert edit.text is None
    assert "cannot say exactly these angles" in edit.diagnostics[0].message


@pytest.mark.parametrize(
    "angles",
    [(0, 0, 0), (0.1, -0.2, 0.3), (3, -1.5, -3), (0, pi / 2, 0), (0.4, -pi / 2, 0), (1, 2, 3)],
)
def test_angles_and_quaternions_are_one_turn(angles: tuple[float, float, float]) -> None:
    again = angles_of(quaternion_of(angles))
    assert again is not None
    for row, other in zip(rotation_matrix(angles), rotation_matrix(again), strict=True):
        assert row == pytest.approx(other, abs=1e-9)
    if abs(angles[1]) <= pi / 2:
        assert again == pytest.approx(angles, abs=1e-9)
    x, y, z, w = quaternion_of(angles)
    assert angles_of((3 * x, 3 * y, 3 * z, 3 * w)) == pytest.approx(again)


TOLD = {
    ('version="1.2"', ""): "`quat_xyzw` counts from version 1.1 of URDF on",
    ('version="1.2"', 'version="1"'): "`1` is no version of URDF",
    ('version="1.2"', 'version="1.3"'): "urdfdom does not read version 1.3 of URDF",
    ('"0 0 1 0"', '"0 0 1 0" rpy="0 0 1"'): "`rpy` and `quat_xyzw` both say how this is turned",
    ('"0 0 1 0"', '"0 0 0 0"'): "a quaternion of zeros turns nothing",
    ('"0 0 1 0"', '"0 0 1"'): "`quat_xyzw` has 3 numbers, and 4 are wanted",
    ("<axis", "<origin/><axis"): "a second `<origin>` in `<joint>` does not count",
    ("</geometry>", "<box/></geometry>"): "`<box>` does not count: a geometry has one shape",
    ("capsule", "cone"): "`<cone>` is no shape of URDF",
}


@pytest.mark.parametrize("places", TOLD)
def test_what_does_not_count_is_told(places: tuple[str, str]) -> None:
    known = [each.message for each in read_urdf(NEW.encode()).diagnostics]
    assert known == ["a `<capsule>` is not read: it counts as no shape"]
    found = read_urdf(NEW.replace(*places).encode()).diagnostics
    assert any(each.message.startswith(TOLD[places]) for each in found)


def test_a_turn_that_does_not_count_is_no_turn_and_is_not_changed() -> None:
    text = NEW.replace('version="1.2"', "")
    edit = make(text, turned(0, 0, 1))
    assert edit.text is not None
    assert edit.text.decode() == text.replace('xyz="1 0 0"', 'xyz="1 0 0" rpy="0 0 1"')


@pytest.mark.parametrize("kind", ["link", "joint", "material"])
def test_what_stands_there_twice_is_not_changed(kind: str) -> None:
    color = '<material name="m"><color rgba="1 0 0 1"/></material>'
    parts = {
        "link": '<link name="b"/>',
        "joint": '<joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint>',
        "material": color,
    }
    text = NEW.replace("</robot>", f"{color}{parts[kind]}</robot>")
    changes: dict[str, Change] = {
        "link": lambda robot: replace(
            robot, links={**robot.links, "b": Link("b", (), (Body(Sphere(1)),))}
        ),
        "joint": turned(0, 0, 1),
        "material": lambda robot: replace(
            robot, materials={"m": robot.materials["m"]._replace(rgba=(0, 1, 0, 1))}
        ),
    }
    edit = make(text, changes[kind])
    assert edit.text is None
    (told,) = edit.diagnostics
    assert "stands here a second time" in told.message
    assert told.span is not None
    assert told.span.start == text.rindex(parts[kind]) + 1


TEXTURED = """\
<robot name="r">
  <link name="a">
    <visual>
      <geometry><sphere radius="1"/></geometry>
      <material name="wood"><texture filename="oak.png"/></material>
    </visual>
  </link>
</robot>
"""


@pytest.mark.parametrize(
    ("material", "told"),
    [
        (Material("red", (1, 0, 0, 1)), ["the texture `oak.png` goes with the colour"]),
        (None, ["the texture `oak.png` goes with the colour"]),
        (Material("wood", (1, 0, 0, 1), "oak.png"), []),
        (Material("wood", None, "elm.png"), []),
    ],
)
def test_a_texture_that_goes_is_told(material: Material | None, told: list[str]) -> None:
    before = read_urdf(TEXTURED.encode()).description
    assert before is not None
    link = before.links["a"]
    bodies = (link.visuals[0]._replace(material=material),)
    edit = edited(
        TEXTURED.encode(), before, replace(before, links={"a": link._replace(visuals=bodies)})
    )
    assert edit.text is not None, edit.diagnostics
    assert [each.message for each in edit.diagnostics] == [
        f"{each} that was there" for each in told
    ]
