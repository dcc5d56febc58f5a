"""What a robot's file refuses is told on the sentence that asks for it, with the file's line."""

from __future__ import annotations

from pathlib import Path

import pytest
from loaded_packages import run

from plastron_tui.diagnostics import Severity

ARM = """\
<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <link name="base"/>
  <link name="hand"><visual><geometry><box size="${w} 1 1"/></geometry></visual></link>
  <joint name="turn" type="prismatic">
    <origin xyz="$(arg place)"/>
    <parent link="base"/><child link="hand"/>
    <limit lower="${-w}" upper="${w}" effort="1" velocity="1"/>
  </joint>
  <link name="eye">
    <visual><origin xyz="${w} 0 0"/><geometry><sphere radius="1"/></geometry></visual>
  </link>
  <joint name="look" type="fixed"><parent link="base"/><child link="eye"/></joint>
</robot>
"""
JOINT = "arm has_joint 'turn' of joint_type prismatic from 'base' to 'hand' at 1, 2, 3\n"
LIMIT = "arm limits_joint 'turn' between 0 and 1 m\n"
ANEW = (
    "arm no_longer_has_joint 'turn'\n"
    "arm has_joint 'turn' of joint_type prismatic from 'base' to 'hand'\n"
)
LINK = "arm has_link 'hand' shaped box 2, 1, 1\n"
IN_FILE = "change it in the file"


@pytest.mark.parametrize(
    ("said", "where", "message", "help_"),
    [
        (JOINT, "1, 2, 3", "`$(arg place)` (in line 5 of `arm.xacro`)", IN_FILE),
        (JOINT.replace("1, 2, 3", "0, 0, 0"), "0, 0, 0", "`$(arg place)`", IN_FILE),
        (LIMIT, "0", "`lower` of `<limit>` is computed by a macro: `${-w}` (in line 7", IN_FILE),
        ("arm has_link 'eye' weighing 1 at 0, 0, 0\n", "0, 0, 0", "`${w} 0 0`", IN_FILE),
        (LINK, LINK, "in line 3 of", IN_FILE),
        ("arm no_longer_has_joint 'turn'\n", "'turn'", "in line 5", IN_FILE),
        # Made anew, it would keep what is computed without a word.
        (ANEW, "'turn'", "`xyz` of `<origin>`", IN_FILE),
    ],
)
def test_a_refusal_is_told_on_its_sentence(
    said: str, where: str, message: str, help_: str, tmp_path: Path
) -> None:
    (tmp_path / "arm.xacro").write_text(ARM)
    program = f"load_robot 'arm.xacro' as arm\n{said}generate_robot arm\n"
    [told] = [x for x in run(program, tmp_path, "rospy") if x.severity is Severity.ERROR]
    assert (told.code, told.file) == ("edit-refused", None)
    assert told.span is not None
    assert program[told.span.start : told.span.end] == where.rstrip("\n")
    assert message in told.message
    assert help_ in (told.help or "")
    assert not (tmp_path / "output").exists()


MADE_BY_MACRO = """\
<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="{0}"><{0}/></xacro:macro>
  <link name="base"/>
  <link name="hand"/>
  <joint name="turn" type="revolute">
    <parent link="base"/><child link="hand"/>
    <xacro:{0}/>
  </joint>
</robot>
"""


@pytest.mark.parametrize(
    ("macro", "where"),
    [("limit", "arm limits_joint"), ("origin", "arm has_joint"), ("axis", "arm has_joint")],
)
def test_of_two_sentences_the_one_that_is_refused_is_told(
    macro: str, where: str, tmp_path: Path
) -> None:
    text = MADE_BY_MACRO.format(macro)
    changed = "at 0, 0, 1" if macro == "origin" else "with axis 0, 0, 1"
    if macro == "limit":
        changed = "of joint_type revolute"
    else:
        limit = '<limit lower="-1" upper="1" effort="1" velocity="1"/>'
        text = text.replace("    <parent", f"    {limit}\n    <parent")
    (tmp_path / "arm.xacro").write_text(text)
    program = f"load_robot 'arm.xacro' as arm\narm has_joint 'turn' {changed}\n"
    program += "arm limits_joint 'turn' between 0 and 45 deg with effort 1 and velocity 1\n"
    program += "generate_robot arm\n"
    [told] = [x for x in run(program, tmp_path, "rospy") if x.severity is Severity.ERROR]
    assert told.span is not None
    assert program[told.span.start : told.span.end].startswith(where)


def test_what_no_macro_computes_changes(tmp_path: Path) -> None:
    (tmp_path / "arm.xacro").write_text(ARM)
    program = "load_robot 'arm.xacro' as arm\n"
    program += "arm limits_joint 'turn' with effort 2 and velocity 3\ngenerate_robot arm\n"
    run(program, tmp_path, "rospy")
    wanted = ARM.replace('effort="1" velocity="1"', 'effort="2" velocity="3"')
    assert (tmp_path / "output/arm.xacro").read_text() == wanted
