"""What is written into a robot's file is written as its author writes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest

from plastron_tui.ros.robots.description import (
    Body,
    Box,
    Description,
    Joint,
    JointType,
    Link,
    Material,
    Pose,
    Sphere,
)
from plastron_tui.sources.urdf.edits import edited
from plastron_tui.sources.urdf.reader import read_urdf

WRAPPED = """\
<robot
  name="r">
  <link
    name="a">
    <visual>
      <origin
        xyz="0 0 0"
        rpy="0 0 0" />
      <geometry>
        <box
          size="1 2 3" />
      </geometry>
    </visual>
  </link>
</robot>
"""
INLINE = """\
<robot name="r">
  <material name="m"><color rgba="1 0 0 1"/></material>
  <link name="a">
    <visual><geometry><box size="1 2 3"/></geometry><material name="m"/></visual>
    <visual><geometry><box size="1 2 3"/></geometry></visual>
  </link>
</robot>
"""
OWN = INLINE.replace('  <material name="m"><color rgba="1 0 0 1"/></material>\n', "").replace(
    '<material name="m"/>', '<material name="m"><color rgba="1 0 0 1"/></material>'
)
JOINED = """\
<robot name="r">
  <link name="a"/>
  <link name="b"/>
  <joint name="j" type="fixed">
    <origin xyz="1.0 2.0 0.5" rpy="0 0 0"/>
    <parent link="a"/>
    <child link="b"/>
  </joint>
</robot>
"""
ORDERED = """\
<robot name="r">
  <link name="a">
    <visual>
      <geometry>
        <box size="1 2 3"/>
      </geometry>
      <origin rpy="0 0 0" xyz="0 0 1"/>
    </visual>
  </link>
  <link name="b"/>
  <link name="d"/>
  <joint type="fixed" name="j">
    <child link="b"/>
    <parent link="a"/>
    <origin rpy="0 0 0" xyz="0 0 0.5"/>
  </joint>
</robot>
"""
GREEN = Material("green", (0, 1, 0, 1))
Change = Callable[[Description], Description]


def visuals(*change: dict[str, object]) -> Change:
    """Return what changes the visuals of the link `a`, one by one."""

    def changed(robot: Description) -> Description:
        link = robot.links["a"]
        bodies = [
            each._replace(**values)  # type: ignore[arg-type]
            for each, values in zip(link.visuals, change, strict=True)
        ]
        return replace(robot, links={**robot.links, "a": link._replace(visuals=tuple(bodies))})

    return changed


def more(robot: Description) -> Description:
    body = Body(Sphere(1), Pose((0, 0, 1)))
    joint = Joint("k", JointType.FIXED, "a", "c", Pose((0, 0, 2)))
    return replace(
        robot,
        links={**robot.links, "c": Link("c", (body,))},
        joints={**robot.joints, "k": joint},
    )


def moved(x: float, y: float, z: float) -> Change:
    def changed(robot: Description) -> Description:
        joint = robot.joints["j"]
        return replace(robot, joints={"j": joint._replace(pose=Pose((x, y, z)))})

    return changed


def visual(color: str) -> str:
    material = f'<material name="m"><color rgba="{color}"/></material>'
    return f'<visual><geometry><sphere radius="1"/></geometry>{material}</visual>'


SHADOWED = f"""\
<robot name="r">
  <link name="a">{visual("1 0 0 1")}</link>
  <link name="b">{visual("0 0 1 1")}{visual("0 0 1 1")}</link>
  <link name="c">{visual("1 0 0 1")}</link>
</robot>
"""


def blue_c(robot: Description) -> Description:
    body = robot.links["c"].visuals[0]._replace(material=Material("m", (0, 0, 1, 1)))
    return replace(robot, links={**robot.links, "c": Link("c", (body, body))})


PAINTED = visuals({"material": GREEN}, {"material": GREEN})
WITH_GREEN = '<material name="green"><color rgba="0 1 0 1"/></material>'
CASES: dict[str, tuple[str, Change, dict[str, str]]] = {
    "attributes in lines of their own": (
        WRAPPED,
        more,
        {
            "</robot>": """\

  <joint
    name="k"
    type="fixed">
    <origin
      xyz="0 0 2"
      rpy="0 0 0" />
    <parent
      link="a" />
    <child
      link="c" />
  </joint>

  <link
    name="c">
    <visual>
      <origin
        xyz="0 0 1"
        rpy="0 0 0" />
      <geometry>
        <sphere
          radius="1" />
      </geometry>
    </visual>
  </link>
</robot>"""
        },
    ),
    "a colour in a line of its own": (
        WRAPPED,
        visuals({"material": GREEN}),
        {
            "    </visual>": """\
      <material
        name="green">
        <color
          rgba="0 1 0 1" />
      </material>
    </visual>"""
        },
    ),
    "colours beside the links": (
        INLINE,
        PAINTED,
        {
            "</material>\n  <link": f"</material>\n  {WITH_GREEN}\n  <link",
            '<material name="m"/>': '<material name="green"/>',
            "</geometry></visual>": '</geometry><material name="green"/></visual>',
        },
    ),
    "a colour said once, within a line": (
        OWN,
        PAINTED,
        {
            '<material name="m"><color rgba="1 0 0 1"/></material>': WITH_GREEN,
            "</geometry></visual>": '</geometry><material name="green"/></visual>',
        },
    ),
    "an element that held nothing, within a line": (
        OWN.replace(
            '<material name="m"><color rgba="1 0 0 1"/></material>', '<material name="m"/>'
        ),
        visuals({"material": Material("m", (1, 0, 0, 1))}, {}),
        {'<material name="m"/>': '<material name="m"><color rgba="1 0 0 1"/></material>'},
    ),
    "a name that means something else, also where it is not looked at": (
        SHADOWED,
        blue_c,
        {
            f'"c">{visual("1 0 0 1")}</link>': f'"c">{visual("0 0 1 1")}'.replace('"m"', '"m_2"')
            + '<visual><geometry><sphere radius="1"/></geometry><material name="m_2"/></visual>'
            "</link>"
        },
    ),
    "a link that held nothing, in its line": (
        SHADOWED.replace('"c">' + visual("1 0 0 1") + "</link>", '"c"/>'),
        lambda robot: replace(
            robot, links={**robot.links, "c": Link("c", (Body(Sphere(1)),), (Body(Sphere(2)),))}
        ),
        {
            '"c"/>': '"c"><visual><geometry><sphere radius="1"/></geometry></visual>'
            '<collision><geometry><sphere radius="2"/></geometry></collision></link>'
        },
    ),
    "numbers as they are there": (
        JOINED.replace(
            '<link name="b"/>', '<link name="b"><inertial><origin xyz="0 0 3"/></inertial></link>'
        ),
        moved(3, 4, 5),
        {"1.0 2.0 0.5": "3.0 4.0 5.0"},
    ),
    "parts no farther apart than anybody reads": (
        JOINED.replace('"a"/>\n', '"a"/>' + "\n" * 9).replace('"b"/>\n', '"b"/>' + "\n" * 9),
        lambda robot: replace(robot, links={**robot.links, "c": Link("c")}),
        {"  </joint>\n": '  </joint>\n\n\n\n  <link name="c"/>\n'},
    ),
    "colours with points": (
        OWN.replace("1 0 0 1", "1.0 0.0 0.0 1.0"),
        visuals({}, {"material": GREEN}),
        {
            "</geometry></visual>": "</geometry>"
            + WITH_GREEN.replace("0 1 0 1", "0.0 1.0 0.0 1.0")
            + "</visual>"
        },
    ),
    "numbers that tell nothing, as elsewhere": (
        JOINED.replace("1.0 2.0 0.5", "0.1 0.2 0.5"),
        moved(3, 4, 0.5),
        {"0.1 0.2 0.5": "3 4 0.5"},
    ),
    "what an author does not say": (
        JOINED.replace(' rpy="0 0 0"', ""),
        more,
        {
            "  </joint>\n": """\
  </joint>
  <link name="c">
    <visual>
      <origin xyz="0.0 0.0 1.0"/>
      <geometry>
        <sphere radius="1"/>
      </geometry>
    </visual>
  </link>
  <joint name="k" type="fixed">
    <origin xyz="0.0 0.0 2.0"/>
    <parent link="a"/>
    <child link="c"/>
  </joint>
""",
        },
    ),
    "what comes first, above the comment of what follows": (
        JOINED.replace('  <link name="a"/>', '  <!-- first -->\n  <link name="a"/>'),
        lambda robot: replace(robot, links={"o": Link("o"), **robot.links}),
        {"  <!-- first -->": '  <link name="o"/>\n  <!-- first -->'},
    ),
    "another visual, behind the one that is there": (
        WRAPPED,
        lambda robot: replace(
            robot,
            links={"a": Link("a", (*robot.links["a"].visuals, Body(Sphere(1), Pose((0, 0, 1)))))},
        ),
        {
            "    </visual>\n": """\
    </visual>
    <visual>
      <origin
        xyz="0 0 1"
        rpy="0 0 0" />
      <geometry>
        <sphere
          radius="1" />
      </geometry>
    </visual>
"""
        },
    ),
    "the author's order, links apart from joints": (
        ORDERED,
        more,
        {
            '  <link name="d"/>\n': """\
  <link name="d"/>
  <link name="c">
    <visual>
      <geometry>
        <sphere radius="1"/>
      </geometry>
      <origin rpy="0 0 0" xyz="0 0 1"/>
    </visual>
  </link>
""",
            "  </joint>\n": """\
  </joint>
  <joint type="fixed" name="k">
    <child link="c"/>
    <parent link="a"/>
    <origin rpy="0 0 0" xyz="0 0 2"/>
  </joint>
""",
        },
    ),
    "a shape in place of another one": (
        WRAPPED,
        visuals({"shape": Sphere(1)}),
        {'<box\n          size="1 2 3" />': '<sphere\n          radius="1" />'},
    ),
    "a number in a line of its own": (
        WRAPPED,
        visuals({"shape": Box((1, 2, 4))}),
        {"1 2 3": "1 2 4"},
    ),
}


BACK = {"a link that held nothing, in its line": ('"c"/>', '"c"></link>')}
"""What is not written back as it was."""


@pytest.mark.parametrize("name", CASES)
def test_what_is_new_is_written_as_the_rest_and_goes_again(name: str) -> None:
    text, change, places = CASES[name]
    expected = text
    for old, new in places.items():
        assert expected.count(old) == 1, old
        expected = expected.replace(old, new)
    before = read_urdf(text.encode()).description
    assert before is not None
    edit = edited(text.encode(), before, change(before))
    assert edit.text is not None, edit.diagnostics
    assert edit.text.decode() == expected
    after = read_urdf(edit.text).description
    assert after is not None
    back = BACK.get(name, ("", ""))
    assert edited(edit.text, after, before).text == text.replace(*back).encode()
