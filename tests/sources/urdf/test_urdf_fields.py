"""Each value of a robot's file, changed by itself and changed back: one place of the text."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from plastron_tui.ros.robots.description import (
    Cylinder,
    Description,
    Dynamics,
    JointType,
    Limit,
    Mesh,
    Mimic,
    Pose,
)
from plastron_tui.sources.urdf.edits import edited
from plastron_tui.sources.urdf.new_elements import number
from plastron_tui.sources.urdf.reader import read_urdf

TEXT = """\
<robot name="r">
  <material name="wood">
    <color rgba="1 0.25 0 1"/>
    <texture filename="wood.png"/>
  </material>
  <link name="a"/>
  <link name="b">
    <visual>
      <geometry>
        <mesh filename="b.stl" scale="2 2 2"/>
      </geometry>
    </visual>
    <collision>
      <geometry>
        <cylinder radius="0.50" length="7"/>
      </geometry>
    </collision>
    <inertial>
      <origin xyz="0 0 0.125"/>
      <mass value="3"/>
      <inertia ixx="11" ixy="0" ixz="0" iyy="12" iyz="0.1" izz="13"/>
    </inertial>
  </link>
  <joint name="j" type="revolute">
    <parent link="a"/>
    <child link="b"/>
    <axis xyz="0 1 0"/>
    <limit lower="-1.5" upper="1.50" effort="20" velocity="4"/>
    <dynamics damping="0.7"/>
    <mimic joint="k" multiplier="-2" offset="0.3"/>
  </joint>
  <joint name="k" type="continuous">
    <parent link="a"/>
    <child link="c"/>
    <limit effort="5" velocity="6"/>
  </joint>
  <link name="c"/>
</robot>
"""

CASES: dict[str, tuple[tuple[Any, ...], Any, str, str]] = {
    "colour": (("materials", "wood", "rgba"), (1, 0.5, 0, 1), "0.25", "0.5"),
    "texture": (("materials", "wood", "texture"), "oak.png", "wood.png", "oak.png"),
    "no texture": (
        ("materials", "wood", "texture"),
        None,
        '    <texture filename="wood.png"/>\n',
        "",
    ),
    "file": (("links", "b", "visuals", 0, "shape"), Mesh("c.stl", (2, 2, 2)), "b.stl", "c.stl"),
    "scale": (("links", "b", "visuals", 0, "shape"), Mesh("b.stl", (2, 3, 2)), "2 2 2", "2 3 2"),
    "no scale": (("links", "b", "visuals", 0, "shape"), Mesh("b.stl"), ' scale="2 2 2"', ""),
    "radius": (("links", "b", "collisions", 0, "shape"), Cylinder(0.75, 7), "0.50", "0.75"),
    "length": (("links", "b", "collisions", 0, "shape"), Cylinder(0.5, 8), '"7"', '"8"'),
    "mass": (("links", "b", "inertial", "mass"), 4, 'value="3"', 'value="4"'),
    "moment": (("links", "b", "inertial", "tensor", "iyz"), 0.2, 'iyz="0.1"', 'iyz="0.2"'),
    "centre": (("links", "b", "inertial", "pose"), Pose((0, 0, 0.5)), "0.125", "0.5"),
    "no centre": (
        ("links", "b", "inertial", "pose"),
        Pose(),
        '      <origin xyz="0 0 0.125"/>\n',
        "",
    ),
    "axis": (("joints", "j", "axis"), (0, 0, 1), "0 1 0", "0 0 1"),
    "no axis": (("joints", "j", "axis"), None, '    <axis xyz="0 1 0"/>\n', ""),
    "parent": (
        ("joints", "j", "parent"),
        "c",
        '<parent link="a"/>\n    <child link="b"',
        '<parent link="c"/>\n    <child link="b"',
    ),
    "child": (("joints", "j", "child"), "d", '<child link="b"', '<child link="d"'),
    "lower": (("joints", "j", "limit", "lower"), -2.5, "-1.5", "-2.5"),
    "upper": (("joints", "j", "limit", "upper"), 2.5, "1.50", "2.5"),
    "effort": (("joints", "j", "limit", "effort"), 30, '"20"', '"30"'),
    "velocity": (("joints", "k", "limit", "velocity"), 9, '"6"', '"9"'),
    "no limit": (("joints", "k", "limit"), None, '    <limit effort="5" velocity="6"/>\n', ""),
    "damping": (("joints", "j", "dynamics", "damping"), 0.9, "0.7", "0.9"),
    "friction": (
        ("joints", "j", "dynamics"),
        Dynamics(0.7, 0.1),
        'damping="0.7"',
        'damping="0.7" friction="0.1"',
    ),
    "no dynamics": (("joints", "j", "dynamics"), None, '    <dynamics damping="0.7"/>\n', ""),
    "mimicked": (("joints", "j", "mimic", "joint"), "l", 'joint="k"', 'joint="l"'),
    "multiplier": (("joints", "j", "mimic", "multiplier"), 2, '"-2"', '"2"'),
    "no multiplier": (("joints", "j", "mimic", "multiplier"), 1, ' multiplier="-2"', ""),
    "offset": (("joints", "j", "mimic", "offset"), 0.4, "0.3", "0.4"),
    "no offset": (("joints", "j", "mimic"), Mimic("k", -2), ' offset="0.3"', ""),
    "a range where none was": (
        ("joints", "k"),
        {"type": JointType.REVOLUTE, "limit": Limit(0, 2, 5, 6)},
        '"continuous">\n    <parent link="a"/>\n    <child link="c"/>\n    <limit effort',
        '"revolute">\n    <parent link="a"/>\n    <child link="c"/>\n'
        '    <limit lower="0" upper="2" effort',
    ),
    "no range any more": (
        ("joints", "j"),
        {"type": JointType.CONTINUOUS, "limit": Limit(0, 0, 20, 4)},
        'revolute">\n    <parent link="a"/>\n    <child link="b"/>\n    <axis xyz="0 1 0"/>\n'
        '    <limit lower="-1.5" upper="1.50" effort',
        'continuous">\n    <parent link="a"/>\n    <child link="b"/>\n    <axis xyz="0 1 0"/>\n'
        "    <limit effort",
    ),
}
"""What is changed, what it becomes, and the text before and after."""

ZERO = ('damping="0.7"', 'damping="0.7" friction="0"')
BACK = {
    "radius": ("0.50", "0.5"),
    "upper": ("1.50", "1.5"),
    "no range any more": ("1.50", "1.5"),
    "friction": ZERO,
    "no dynamics": ZERO,
}
"""What is not written back as it was: the author's digits, and what was left unsaid."""


def changed(value: Any, path: tuple[Any, ...], new: Any) -> Any:
    """Return a part with one of its values changed."""
    if not path:
        return value._replace(**new) if isinstance(new, dict) else new
    first, *rest = path
    inner = value[first] if isinstance(value, dict) or first == 0 else getattr(value, first)
    inner = changed(inner, tuple(rest), new)
    if isinstance(value, dict):
        return {**value, first: inner}
    if first == 0:
        return (inner, *value[1:])
    fields = {first: inner}
    return replace(value, **fields) if isinstance(value, Description) else value._replace(**fields)


@pytest.mark.parametrize("name", CASES)
def test_a_value_is_changed_where_it_stands_and_back(name: str) -> None:
    path, new, old_text, new_text = CASES[name]
    before = read_urdf(TEXT.encode()).description
    assert before is not None
    assert TEXT.count(old_text) == 1
    after = changed(before, path, new)
    edit = edited(TEXT.encode(), before, after)
    assert edit.text is not None, edit.diagnostics
    assert edit.text.decode() == TEXT.replace(old_text, new_text)
    back = edited(edit.text, after, before).text
    assert back == TEXT.replace(*BACK.get(name, ("", ""))).encode()


def test_what_an_author_says_elsewhere_though_it_is_so_without_stays_said() -> None:
    other = '<limit effort="5" velocity="6"/>'
    text = TEXT.replace(other, f'{other}\n    <mimic joint="l" multiplier="1" offset="0"/>')
    before = read_urdf(text.encode()).description
    assert before is not None
    after = changed(before, ("joints", "j", "mimic"), Mimic("k"))
    edit = edited(text.encode(), before, after)
    assert edit.text == text.replace('"-2"', '"1"').replace("0.3", "0").encode()


@pytest.mark.parametrize(
    ("value", "text"),
    [(-0.0, "0"), (5.0, "5"), (0.1, "0.1"), (1 / 3, "0.3333333333"), (1.57079632679,) * 2],
)
def test_numbers_have_the_digits_that_people_write(value: float, text: object) -> None:
    assert number(value) == str(text)
