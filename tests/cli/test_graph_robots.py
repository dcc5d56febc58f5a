"""`plastron graph` of robots: of programs, and of their own files."""

from __future__ import annotations

import json
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest
from click.testing import CliRunner

from plastron_tui.cli.group import cli as main

URDF = """\
<robot name="cart">
  <link name="base"><visual><geometry><box size="1 1 1"/></geometry></visual></link>
  <link name="wheel"><visual><geometry><sphere radius="0.1"/></geometry></visual></link>
  <joint name="axle" type="continuous">
    <parent link="base"/><child link="wheel"/><axis xyz="0 1 0"/>
  </joint>
</robot>
"""
PROGRAM = """\
create_robot 'rover' as robot
robot has_link 'base' shaped box 0.4, 0.3, 0.1
create_node 'driver' as driver using rclpy
subscribe driver to 'cmd_vel' of message_type Twist
generate_robot robot
"""


def _run(*arguments: str | Path) -> tuple[int, str, str]:
    result = CliRunner().invoke(main, ["graph", *map(str, arguments)])
    return result.exit_code, result.stdout, result.stderr


@pytest.fixture
def cart(tmp_path: Path) -> Path:
    file = tmp_path / "cart.urdf"
    file.write_text(URDF)
    return file


def test_a_file_of_a_robot_is_shown_by_itself(cart: Path) -> None:
    assert _run(cart) == (
        0,
        "cart: 2 links, 1 joint · cart.urdf\n"
        "  base           box 1 × 1 × 1 m\n"
        "  ↓ wheel  axle  continuous about y  sphere r 0.1 m\n",
        "",
    )


def test_robots_of_programs_and_of_files_are_in_one_graph(tmp_path: Path, cart: Path) -> None:
    program = tmp_path / "a.plastron"
    program.write_text(PROGRAM)
    status, out, err = _run("-f", "json", program, cart)
    assert (status, err) == (0, "")
    found = json.loads(out)
    assert [each["name"] for each in found["nodes"]] == ["driver"]
    robots = [(each["name"], each["variable"], each["generated"]) for each in found["robots"]]
    assert robots == [("rover", "robot", True), ("cart", "cart", False)]
    status, out, err = _run("-f", "svg", program, cart)
    assert (status, err) == (0, "")
    assert "cart: 2 links, 1 joint" in out
    ET.fromstring(out)


def test_two_programs_may_call_their_robots_alike(tmp_path: Path) -> None:
    for name in ("a", "b"):
        (tmp_path / f"{name}.plastron").write_text(PROGRAM)
    status, out, _ = _run("-f", "json", tmp_path / "a.plastron", tmp_path / "b.plastron")
    robots = json.loads(out)["robots"]
    assert [(each["variable"], each["generated"]) for each in robots] == [
        ("robot", True),
        ("robot_2", True),
    ]
    assert status == 0


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        ("gone.urdf", None, "`gone.urdf` cannot be read: no such file or directory"),
        ("a.urdf", "<robot", "a.urdf"),
        ("a.urdf", "<sdf/>", "`a.urdf` is a model of Gazebo (SDF), not URDF"),
    ],
)
def test_a_file_without_a_robot_is_told(
    tmp_path: Path, name: str, text: str | None, said: str
) -> None:
    if text is not None:
        (tmp_path / name).write_text(text)
    status, out, err = _run(tmp_path / name)
    assert (status, out) == (1 if (tmp_path / name).exists() else 2, "")
    assert said in err


def test_macros_that_are_not_expanded_are_told_in_the_picture(tmp_path: Path) -> None:
    file = tmp_path / "cart.urdf.xacro"
    file.write_text(URDF.replace("<robot", '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"')
                    .replace("</robot>", '<xacro:more/></robot>'))  # fmt: skip
    status, out, err = _run(file)
    assert status == 0
    assert "macros not expanded" in out
    assert "not trusted" in err


@pytest.mark.parametrize("option", ["--remap", "--namespace"])
def test_names_are_for_programs(cart: Path, option: str) -> None:
    status, out, err = _run(cart, option, "a:=b" if option == "--remap" else "/a")
    assert (status, out) == (2, "")
    assert f"{option} is for programs" in err
