"""Types of a program that belong to packages which it loads."""

from __future__ import annotations

from pathlib import Path

import pytest
from loaded_packages import AMENT_PYTHON, KINDS, lay, run, texts

LOADED = "load_package 'demo' as demo\n"
SPEED = f"{LOADED}create_message_type Speed with float64 left, float64 right\n"
USED = (
    "create_node 'driver' as driver\n"
    "create_message fast of message_type Speed and input 1.0, 2.0\n"
    "driver publish fast to 'speed' of message_type Speed\n"
)
IN = "demo contains driver\ngenerate_package demo\n"


def test_a_python_package_gets_its_types_in_a_package_beside_it(tmp_path: Path) -> None:
    lay(tmp_path, AMENT_PYTHON)
    assert run(f"{SPEED}{USED}{IN}", tmp_path, "rclpy") == ()
    made = texts(tmp_path / "output")
    assert made["demo_interfaces/msg/Speed.msg"] == b"float64 left\nfloat64 right\n"
    assert b"<exec_depend>demo_interfaces</exec_depend>" in made["demo/package.xml"]
    assert b'"msg/Speed.msg"' in made["demo_interfaces/CMakeLists.txt"]


@pytest.mark.parametrize(
    ("kind", "type_", "end"),
    [("catkin", "Speed", ""), ("ament_cmake", "demo/Speed", ""), ("ament_python", "Speed", "")],
)
def test_a_type_of_a_package_that_nothing_writes_is_told(
    kind: str, type_: str, end: str, tmp_path: Path
) -> None:
    library, files = KINDS[kind]
    lay(tmp_path, files)
    if kind == "ament_python":
        lay(tmp_path, {"package.xml": files["package.xml"]}, "demo_interfaces")
    program = SPEED.replace("Speed", type_) + USED
    told = run(f"{program}generate_node driver{end}\n", tmp_path, library)
    assert [(each.code, each.span is not None) for each in told] == [("type-not-written", True)]
    assert not (tmp_path / "output").exists()
