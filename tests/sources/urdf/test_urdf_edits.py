"""What is changed in a robot's file that somebody wrote; every other byte stays."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from difflib import unified_diff
from pathlib import Path
from typing import Any

import pytest

from plastron_tui.ros.robots.description import (
    Body,
    Box,
    Description,
    Joint,
    JointType,
    Limit,
    Link,
    Material,
    Pose,
    Sphere,
)
from plastron_tui.sources.urdf.edits import UrdfEdit, edited
from plastron_tui.sources.urdf.equality import same_robot
from plastron_tui.sources.urdf.reader import read_urdf

ROVER = """\
<?xml version='1.0' encoding='utf-8'?>
<!-- by hand -->
<robot name='rover'>

    <material name='blue'>
        <color rgba='0 0 0.80 1' />
    </material>

    <!-- where all begins -->
    <link name='base' />

    <!-- what is seen -->
    <link name='body'>
        <inertial>
            <mass value='5.0' /> <!-- weighed -->
            <inertia ixx='0.1' ixy='0' ixz='0' iyy='0.1' iyz='0' izz='0.1' />
        </inertial>
        <visual>
            <geometry>
                <box size='0.40  0.30 0.10' />
            </geometry>
            <material name='blue' />
        </visual>
    </link>

    <!-- what holds it -->
    <joint name='hold' type='fixed'>
        <parent link='base' />
        <child link='body' />
        <origin xyz='0 0 0.050' rpy='0 0 0' />
    </joint>

    <transmission name='t'><joint name='hold' /></transmission>
</robot>
"""

Change = Callable[[Description], Description]


def link(name: str, **values: Any) -> Change:
    def change(robot: Description) -> Description:
        new = robot.links.get(name, Link(name))._replace(**values)
        return replace(robot, links={**robot.links, name: new})

    return change


def seen(**values: Any) -> Change:
    def change(robot: Description) -> Description:
        body = robot.links["body"].visuals[0]._replace(**values)
        return link("body", visuals=(body,))(robot)

    return change


def joint(**values: Any) -> Change:
    def change(robot: Description) -> Description:
        new = robot.joints["hold"]._replace(**values)
        return replace(robot, joints={"hold": new})

    return change


def arm(robot: Description) -> Description:
    wrist = Joint("wrist", JointType.CONTINUOUS, "body", "arm")
    return replace(
        robot,
        links={**robot.links, "arm": Link("arm")},
        joints={**robot.joints, "wrist": wrist},
    )


def without_body(robot: Description) -> Description:
    return replace(robot, links={"base": robot.links["base"]}, joints={})


CHANGES: dict[str, tuple[Change, str]] = {
    "a number of several": (
        seen(shape=Box((0.4, 0.35, 0.1))),
        "-                <box size='0.40  0.30 0.10' />\n"
        "+                <box size='0.40  0.35 0.10' />\n",
    ),
    "another shape": (
        seen(shape=Sphere(0.2)),
        "-                <box size='0.40  0.30 0.10' />\n"
        "+                <sphere radius='0.2' />\n",
    ),
    "an origin that was not there": (
        seen(pose=Pose((0, 0, 1))),
        "+            <origin xyz='0 0 1' rpy='0 0 0' />\n",
    ),
    "an origin that says what is so unsaid": (
        joint(pose=Pose()),
        "-        <origin xyz='0 0 0.050' rpy='0 0 0' />\n"
        "+        <origin xyz='0 0 0' rpy='0 0 0' />\n",
    ),
    "something to collide with": (
        link("body", collisions=(Body(Sphere(1)),)),
        "+        <collision>\n"
        "+            <geometry>\n"
        "+                <sphere radius='1' />\n"
        "+            </geometry>\n"
        "+        </collision>\n",
    ),
    "something in a link that has nothing": (
        link("base", collisions=(Body(Sphere(1)),)),
        "-    <link name='base' />\n"
        "+    <link name='base'>\n"
        "+        <collision>\n"
        "+            <geometry>\n"
        "+                <sphere radius='1' />\n"
        "+            </geometry>\n"
        "+        </collision>\n"
        "+    </link>\n",
    ),
    "a colour of its own": (
        seen(material=Material("red", (1, 0, 0, 1))),
        "+    </material>\n"
        "+    <material name='red'>\n"
        "+        <color rgba='1 0 0 1' />\n"
        "-            <material name='blue' />\n"
        "+            <material name='red' />\n",
    ),
    "a colour of a name that means another one": (
        seen(material=Material("blue", (1, 0, 0, 1))),
        "+    </material>\n"
        "+    <material name='blue_2'>\n"
        "+        <color rgba='1 0 0 1' />\n"
        "-            <material name='blue' />\n"
        "+            <material name='blue_2' />\n",
    ),
    "a joint that moves": (
        joint(
            type=JointType.REVOLUTE,
            axis=(0, 1, 0),
            limit=Limit(-1, 1, 10, 2),
            pose=Pose((0, 0, 0.05), (0, 0, 1.5)),
        ),
        "-    <joint name='hold' type='fixed'>\n"
        "+    <joint name='hold' type='revolute'>\n"
        "-        <origin xyz='0 0 0.050' rpy='0 0 0' />\n"
        "+        <origin xyz='0 0 0.050' rpy='0 0 1.5' />\n"
        "+        <axis xyz='0 1 0' />\n"
        "+        <limit lower='-1' upper='1' effort='10' velocity='2' />\n",
    ),
    "a new link and what holds it": (
        arm,
        "+    <link name='arm' />\n"
        "+\n"
        "+    <joint name='wrist' type='continuous'>\n"
        "+        <parent link='body' />\n"
        "+        <child link='arm' />\n"
        "+    </joint>\n"
        "+\n",
    ),
    "a link without its inertia": (
        link("body", inertial=None),
        "-        <inertial>\n"
        "-            <mass value='5.0' /> <!-- weighed -->\n"
        "-            <inertia ixx='0.1' ixy='0' ixz='0' iyy='0.1' iyz='0' izz='0.1' />\n"
        "-        </inertial>\n",
    ),
    "another name": (
        lambda robot: replace(robot, name="a'b"),
        "-<robot name='rover'>\n+<robot name='a&apos;b'>\n",
    ),
    "nothing but the digits": (seen(shape=Box((0.4, 0.3 + 1e-13, 0.1))), ""),
}


def make(text: bytes, change: Change) -> UrdfEdit:
    before = read_urdf(text).description
    assert before is not None
    return edited(text, before, change(before), Path("rover.urdf"))


@pytest.mark.parametrize("newline", ["\n", "\r\n"])
@pytest.mark.parametrize("name", CHANGES)
def test_only_what_is_different_changes(name: str, newline: str) -> None:
    change, expected = CHANGES[name]
    edit = make(ROVER.replace("\n", newline).encode(), change)
    assert edit.text is not None, edit.diagnostics
    assert edit.text.count(b"\r\n") == (edit.text.count(b"\n") if newline == "\r\n" else 0)
    after = edit.text.decode().replace("\r\n", "\n")
    lines = unified_diff(ROVER.splitlines(True), after.splitlines(True), n=0)
    assert "".join(line for line in lines if line[:2] not in ("--", "++", "@@")) == expected


def test_what_still_names_a_part_that_is_gone_is_told() -> None:
    edit = make(ROVER.encode(), without_body)
    assert edit.text is not None
    assert b"what holds it" in edit.text
    assert b"<link name='body'" not in edit.text
    assert [each.message for each in edit.diagnostics] == [
        "a comment stays that stood above `body`, which is taken away: line 12",
        "a comment stays that stood above `hold`, which is taken away: line 26",
        "`<joint>` in line 33 still names `hold`, which is taken away",
    ]


def test_a_definition_that_others_mean_stays_when_its_own_link_goes() -> None:
    text = (
        '<robot name="r"><link name="a"><visual><geometry><sphere radius="1"/></geometry>'
        '<material name="m"><color rgba="1 0 0 1"/></material></visual></link>'
        '<link name="b"><visual><geometry><sphere radius="1"/></geometry><material name="m"/>'
        "</visual></link></robot>"
    )
    edit = make(text.encode(), lambda robot: replace(robot, links={"b": robot.links["b"]}))
    assert edit.text is not None
    again = read_urdf(edit.text)
    assert again.diagnostics == ()
    assert again.description is not None
    assert again.description.links["b"].visuals[0].material == Material("m", (1, 0, 0, 1))


def test_numbers_are_written_as_the_author_writes_them() -> None:
    text = (
        '<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="continuous">'
        '<origin xyz="0.0 1.0 2.5" rpy="0 0 1"/><parent link="a"/><child link="b"/>'
        '<limit effort="28.0" velocity="6.28318530718"/></joint></robot>'
    )

    def change(robot: Description) -> Description:
        old = robot.joints["j"]
        assert old.limit is not None
        limit = old.limit._replace(effort=12)
        new = old._replace(pose=Pose((3, 1, 2.5), (0, 2, 1)), limit=limit)
        return replace(robot, joints={"j": new})

    edit = make(text.encode(), change)
    assert edit.text is not None
    expected = text.replace("0.0 1.0 2.5", "3.0 1.0 2.5").replace("0 0 1", "0 2 1")
    assert edit.text.decode() == expected.replace("28.0", "12.0")
    read = read_urdf(text.encode()).description
    assert read is not None
    assert edited(edit.text, change(read), read).text == text.encode()


def test_nothing_is_written_between_a_link_and_the_joint_that_holds_it() -> None:
    def held(name: str, parent: str) -> str:
        ends = f'<parent link="{parent}"/><child link="{name}"/>'
        return f'<joint name="to_{name}" type="fixed">{ends}</joint>\n'

    links = {name: f'<link name="{name}"/>\n' for name in ("a", "b", "c", "d")}
    pairs = held("b", "a") + links["b"] + held("c", "b") + links["c"] + links["d"] + held("d", "a")
    text = f'<robot name="r">\n{links["a"]}{pairs}</robot>\n'

    def more(robot: Description) -> Description:
        joint = Joint("to_e", JointType.FIXED, "a", "e")
        return replace(
            robot,
            links={**robot.links, "e": Link("e")},
            joints={**robot.joints, "to_e": joint},
        )

    edit = make(text.encode(), more)
    assert edit.text is not None
    assert edit.text.startswith(text.removesuffix("</robot>\n").encode())


def test_a_part_that_stands_there_twice_is_not_taken_away() -> None:
    text = ROVER.replace("<link name='base' />", "<link name='base' /> <link name='base' />")
    edit = make(text.encode(), lambda robot: replace(robot, links={}))
    assert edit.text is None
    assert "stands here a second time" in edit.diagnostics[0].message
    span = edit.diagnostics[0].span
    assert span is not None
    assert span.start == text.rindex("link name='base'")


MACROS = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="h" value="1"/>
  <link name="a"/>
  <link name="b"/>
  <joint name="j" type="fixed">
    <parent link="a"/>
    <child link="b"/>
    <origin xyz="0 0 ${h}" rpy="0 0 0.5"/>
  </joint>
</robot>
"""


def test_what_macros_compute_is_not_changed() -> None:
    def moved(pose: Pose) -> Change:
        return lambda robot: replace(robot, joints={"j": robot.joints["j"]._replace(pose=pose)})

    edit = make(MACROS.encode(), moved(Pose((1, 2, 3), (0, 0, 0.5))))
    assert edit.text is None
    (refused,) = edit.diagnostics
    assert refused.message == "`xyz` of `<origin>` is computed by a macro: `0 0 ${h}`"
    assert refused.span is not None
    assert MACROS[refused.span.start :].startswith("origin")
    edit = make(MACROS.encode(), moved(Pose(rotation=(0, 0, 0.7))))
    assert edit.text == MACROS.replace("0 0 0.5", "0 0 0.7").encode()


def test_what_a_macro_may_write_is_not_written_beside_it() -> None:
    text = MACROS.replace('<link name="b"/>', '<link name="b"><xacro:inertia m="1"/></link>')
    edit = make(text.encode(), link("b", visuals=(Body(Sphere(1)),)))
    assert edit.text is None
    assert "`<xacro:inertia>` may write a `<visual>` here" in edit.diagnostics[0].message


def test_a_difference_is_made_in_what_the_file_says_by_now() -> None:
    before = read_urdf(ROVER.encode()).description
    assert before is not None
    by_hand = ROVER.replace("0.40  0.30 0.10", "0.40  0.30 0.20").encode()
    moved = joint(pose=Pose((0, 0, 0.07)))(before)
    edit = edited(by_hand, before, moved)
    assert edit.text == by_hand.replace(b"0.050", b"0.07")
    edit = edited(by_hand, before, seen(shape=Box((1, 1, 1)))(before))
    assert edit.text is None
    assert "something else of the link `body` by now" in edit.diagnostics[0].message


@pytest.mark.parametrize("text", [b"<robot name='r'/>", b"<robot name='r'>\n</robot>"])
def test_a_robot_of_nothing_gets_all(text: bytes) -> None:
    wanted = read_urdf(ROVER.encode()).description
    before = read_urdf(text).description
    assert wanted is not None
    assert before is not None
    edit = edited(text, before, wanted)
    assert edit.text is not None, edit.diagnostics
    again = read_urdf(edit.text).description
    assert again is not None
    assert same_robot(again, wanted)
