"""`plastron inspect` of the descriptions of robots, and other commands with robots."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from command_line import Run

ARM = """\
<robot name="arm">
  <link name="base"/>
  <link name="upper">
    <visual><geometry><box size="0.1 0.1 0.5"/></geometry></visual>
    <inertial><mass value="2"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
  </link>
  <joint name="shoulder" type="revolute">
    <origin xyz="0 0 0.25"/>
    <parent link="base"/>
    <child link="upper"/>
    <axis xyz="0 1 0"/>
    <limit lower="-1.570796327" upper="0.5" effort="10" velocity="1"/>
  </joint>
</robot>
"""


def test_a_robot_is_shown_as_its_tree(run: Run, here: Path) -> None:
    (here / "arm.urdf").write_text(ARM)
    told = run("inspect", "arm.urdf").stdout.decode().splitlines()
    assert told[:2] == ["arm.urdf (URDF)", "  robot arm"]
    assert told[2].split() == ["base"]
    assert told[3].split(maxsplit=3)[:3] == ["upper", "revolute", "shoulder"]
    assert "box 0.1, 0.1, 0.5, 2 kg, at 0, 0, 0.25, axis 0, 1, 0" in told[3]


def test_json_has_what_the_file_says(run: Run, here: Path) -> None:
    (here / "arm.urdf").write_text(ARM)
    found = json.loads(run("inspect", "-f", "json", "arm.urdf").stdout)
    assert (found["file"], found["robot"], found["root"]) == ("arm.urdf", "arm", "base")
    assert [each["name"] for each in found["links"]] == ["base", "upper"]
    assert found["links"][0] == {"name": "base", "visuals": [], "collisions": []}
    upper = found["links"][1]
    assert upper["inertial"]["mass"] == 2
    assert upper["visuals"][0]["shape"] == "box"
    [joint] = found["joints"]
    assert joint["parent"] == "base"
    assert joint["limit"]["upper"] == 0.5
    assert "mimic" not in joint
    assert found["faults"] == []


def test_a_program_describes_the_same(run: Run, here: Path) -> None:
    (here / "arm.urdf").write_text(ARM)
    (here / "again.plastron").write_bytes(run("inspect", "-f", "plastron", "arm.urdf").stdout)
    assert "between -1.570796327 and 0.5 rad" in (here / "again.plastron").read_text()
    assert run("check", "again.plastron").returncode == 0


@pytest.mark.parametrize(
    ("text", "status", "told"),
    [
        ("<robot name='a'>", 1, b"broken-xml"),
        ("<sdf/>", 1, b"broken-urdf"),
        ("", 1, b"error"),
        ('<robot name="a"><link name="b"/><link name="b"/></robot>', 1, b"`b`"),
        # What is wrong with the whole can be changed by a program that loads it.
        ('<robot name="a"><link name="b"/><link name="c"/></robot>', 0, b"no-tree"),
        (ARM.replace('<child link="upper"/>', '<child link="uper"/>'), 0, b"`uper`"),
    ],
)
def test_what_is_wrong_is_told(run: Run, here: Path, text: str, status: int, told: bytes) -> None:
    (here / "arm.urdf").write_text(text)
    done = run("inspect", "arm.urdf")
    assert done.returncode == status, done.stderr
    assert told in done.stderr


def test_json_has_what_is_wrong(run: Run, here: Path) -> None:
    text = '<robot name="a">\n  <link name="b"/>\n  <link name="c"/>\n</robot>\n'
    (here / "arm.urdf").write_text(text)
    found = json.loads(run("inspect", "-f", "json", "arm.urdf").stdout)
    [fault] = found["faults"]
    assert (fault["code"], fault["file"]) == ("no-tree", "arm.urdf")
    assert fault["range"]["start"]["line"] == 3
    assert found["root"] is None


def test_names_reach_no_terminal_raw(run: Run, here: Path) -> None:
    (here / "arm.urdf").write_text(ARM.replace("upper", "up\u009b2Jper"))
    for format_ in ("text", "json", "plastron"):
        assert "\u009b" not in run("inspect", "-f", format_, "arm.urdf").stdout.decode()


@pytest.mark.parametrize("command", ["check", "generate"])
def test_a_robot_that_is_not_written_is_told(run: Run, here: Path, command: str) -> None:
    (here / "a.plastron").write_text("create_robot 'rover' as rover\nrover has_link 'base'\n")
    assert b"`generate_robot rover`" in run(command, "a.plastron").stderr


@pytest.mark.parametrize("named", [["rover"], []])
def test_a_robot_is_run_by_what_its_package_has(run: Run, here: Path, named: list[str]) -> None:
    (here / "a.plastron").write_text(
        "create_robot 'rover' as rover\nrover has_link 'base'\ngenerate_robot rover\n"
    )
    told = run("run", "a.plastron", *named)
    assert told.returncode == 1
    assert (
        b"put it into one: `create_package 'rover_description' as package`, then "
        b"`package contains rover` and `generate_package package`"
    ) in told.stderr
