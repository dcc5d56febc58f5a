"""New packages of nodes in C++, built by the build tools of their ROS, and run."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from cpp_builds import CppLibrary, find_rclcpp
from cpp_packages import plain_package, ros1_package, ros2_package
from made_packages import write
from ros_workspaces import SYSTEM, call, complete_ros2, skip_without

from plastron_tui.targets.packages import render_package

pytestmark = [pytest.mark.live, pytest.mark.long]

STRICT = {"CXXFLAGS": "-Wall -Wextra -Wpedantic -Werror"}


@pytest.fixture(scope="module")
def rclcpp(tmp_path_factory: pytest.TempPathFactory) -> CppLibrary:
    return find_rclcpp(tmp_path_factory)


def test_catkin_builds_a_program_a_nodelet_and_a_script(tmp_path: Path) -> None:
    skip_without("catkin_make", "rosmaster", path=SYSTEM)
    write(render_package(ros1_package(tmp_path)), tmp_path / "src/demo")
    call(["catkin_make", "install"], tmp_path, {"PATH": SYSTEM, **STRICT})
    installed = tmp_path / "install"
    for name in ("talker", "echo.py"):
        assert os.access(installed / "lib/demo" / name, os.X_OK)
    assert (installed / "lib/libdemo_relay.so").is_file()
    call(["catkin_make", "run_tests"], tmp_path, {"PATH": SYSTEM})
    told = call(["catkin_test_results", "build"], tmp_path, {"PATH": SYSTEM})
    assert "3 tests, 0 errors, 0 failures" in told


def test_colcon_builds_a_program_and_a_script(rclcpp: CppLibrary, tmp_path: Path) -> None:
    environ = rclcpp.building(complete_ros2(tmp_path))
    # A component cannot be built with the stand-in.
    make = ros2_package if rclcpp.is_real else plain_package
    write(render_package(make(tmp_path)), tmp_path / "src/demo")
    call(["colcon", "build"], tmp_path, {**environ, **STRICT})
    for name in ("talker", "echo", *(["relay"] if rclcpp.is_real else [])):
        assert os.access(tmp_path / "install/demo/lib/demo" / name, os.X_OK)
    assert not list((tmp_path / "install/demo").rglob("*.hpp")) or rclcpp.is_real
    call(["colcon", "test"], tmp_path, environ)
    told = call(["colcon", "test-result", "--verbose"], tmp_path, environ)
    assert ", 0 errors, 0 failures" in told, told
