"""The output folder alone, with a loaded package that got a node, built by the tools of its ROS."""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path

import pytest
from loaded_packages import IN, KINDS, lay, run
from ros_workspaces import SCRIPTS, SYSTEM, call, complete_ros2, skip_without

pytestmark = [pytest.mark.live]

NAMES = {
    "ament_python": ("listener", "talker"),
    "ament_cmake": ("listener.py", "talker.py"),
    "catkin": ("listener.py", "talker.py"),
}


@pytest.mark.long(1)
@pytest.mark.parametrize("kind", KINDS)
def test_the_output_folder_is_built_alone(kind: str, tmp_path: Path) -> None:
    library, files = KINDS[kind]
    package = lay(tmp_path, files)
    assert run(IN, tmp_path, library) == ()
    shutil.rmtree(package)
    (tmp_path / "output").rename(tmp_path / "src")
    if kind == "catkin":
        skip_without("catkin_make", path=SYSTEM)
        call(["catkin_make", "-j1", "install"], tmp_path, {"PATH": SYSTEM})
        installed = tmp_path / "install"
    else:
        pytest.importorskip("rclpy")
        path = f"{SCRIPTS}:{SYSTEM}"
        skip_without("colcon", "cmake", path=path)
        call(["colcon", "build"], tmp_path, {"PATH": path, "AMENT_PREFIX_PATH": sys.prefix})
        installed = tmp_path / "install/demo"
    for name in NAMES[kind]:
        assert os.access(installed / "lib/demo" / name, os.X_OK)


TYPES = {
    "ament_cmake": "create_message_type demo/Speed with std_msgs/Header header\n",
    "catkin": "create_action_type Dock with std_msgs/Header header returning none reporting none\n",
}


@pytest.mark.long(1)
@pytest.mark.parametrize("kind", TYPES)
def test_types_that_a_loaded_package_gets_are_built(kind: str, tmp_path: Path) -> None:
    library, files = KINDS[kind]
    if kind == "ament_cmake":
        # It has no Python module of its own, which would have the types' name.
        drop = "ament_python_install_package(${PROJECT_NAME})\n"
        files = {**files, "CMakeLists.txt": files["CMakeLists.txt"].replace(drop, "")}
    package = lay(tmp_path, files)
    program = f"load_package 'demo' as demo\n{TYPES[kind]}generate_package demo\n"
    assert run(program, tmp_path, library) == ()
    shutil.rmtree(package)
    (tmp_path / "output").rename(tmp_path / "src")
    name = "Speed" if kind == "ament_cmake" else "DockAction"
    if kind == "catkin":
        skip_without("catkin_make", path=SYSTEM)
        call(["catkin_make", "-j1"], tmp_path, {"PATH": SYSTEM})
    else:
        pytest.importorskip("rclpy")
        skip_without("colcon", "cmake", path=f"{SCRIPTS}:{SYSTEM}")
        call(["colcon", "build"], tmp_path, complete_ros2(tmp_path))
    made = (tmp_path / ("devel" if kind == "catkin" else "install")).rglob("*.py")
    stems = {each.stem.strip("_").lower() for each in made}
    assert name.lower() in stems
