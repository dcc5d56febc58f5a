"""New packages, built by the build tools of their ROS, and their own tests run."""

from __future__ import annotations

import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest
from made_packages import TALKER, spec_of, with_types, write
from ros_workspaces import SCRIPTS, SYSTEM, call, skip_without

from plastron_tui.targets.packages import BuildType, render_package

pytestmark = [pytest.mark.live]

MANAGED = """\
create_node 'lamp' as lamp managed
lamp provides_service 'switch' of service_type SetBool
generate_node lamp
"""


@pytest.mark.long(1)
def test_catkin_package_is_built_and_launched(tmp_path: Path) -> None:
    skip_without("catkin_make", "roslaunch", "rosmaster", path=SYSTEM)
    spec = with_types(spec_of("rospy", tmp_path))
    write(render_package(spec), tmp_path / "src" / "demo")
    system = {"PATH": SYSTEM}
    call(["catkin_make", "-j1"], tmp_path, system)
    call(["catkin_make", "-j1", "install"], tmp_path, system)
    installed = tmp_path / "install"
    assert os.access(installed / "lib/demo/talker.py", os.X_OK)
    assert (installed / "share/demo/launch/demo.launch").is_file()
    assert (installed / "share/demo/config/demo.yaml").is_file()
    assert (installed / "share/demo/urdf/rover.urdf").is_file()
    use = ". devel/setup.sh && cd src/demo && exec "
    call(["sh", "-c", f"{use} python3 -c 'from demo.srv import SetLevel'"], tmp_path, system)
    call(["catkin_make", "-j1", "run_tests"], tmp_path, system)
    told = call(["catkin_test_results", "build"], tmp_path, system)
    # Those of the two nodes, and that of the launch file.
    assert "3 tests, 0 errors, 0 failures" in told
    told = call(
        ["sh", "-c", ". devel/setup.sh && roslaunch --nodes demo demo.launch"], tmp_path, system
    )
    assert told.split() == ["/talker"]


@pytest.mark.long(2)
@pytest.mark.parametrize("build_type", [BuildType.AMENT_PYTHON, BuildType.AMENT_CMAKE_PYTHON])
def test_colcon_builds_and_tests_a_package(build_type: BuildType, tmp_path: Path) -> None:
    pytest.importorskip("rclpy")
    pytest.importorskip("domain_coordinator")
    path = f"{SCRIPTS}:{SYSTEM}"
    skip_without("colcon", "cmake", path=path)
    spec = spec_of("rclpy", tmp_path, TALKER + MANAGED, build_type)
    write(render_package(spec), tmp_path / "src" / "demo")
    wheels = {"PATH": path, "AMENT_PREFIX_PATH": sys.prefix}
    assert call(["colcon", "list", "-n"], tmp_path, wheels).split() == ["demo"]
    call(["colcon", "build"], tmp_path, wheels)
    installed = tmp_path / "install" / "demo"
    for node in spec.nodes:
        assert os.access(installed / "lib/demo" / node.executable, os.X_OK)
    assert (installed / "share/demo/launch/demo.launch").is_file()
    assert (installed / "share/demo/config/demo.yaml").is_file()
    assert (installed / "share/demo/urdf/rover.urdf").is_file()
    for node in spec.nodes:
        # A status of 124 is that of `timeout`: the node was still there. A signal that meets it
        # while it starts may leave it running; it is then killed, with status 137.
        start = f"timeout -k 30 3 install/demo/lib/demo/{node.executable}"
        start += " || case $? in 124|137) ;; *) false;; esac"
        call(["bash", "-c", f". install/setup.bash && {{ {start}; }}"], tmp_path, wheels)
    call(["colcon", "test"], tmp_path, wheels)
    told = call(["colcon", "test-result", "--verbose"], tmp_path, wheels)
    assert ", 0 errors, 0 failures" in told


@pytest.mark.long(1)
def test_colcon_builds_a_package_of_launch_files(tmp_path: Path) -> None:
    pytest.importorskip("rclpy")
    path = f"{SCRIPTS}:{SYSTEM}"
    skip_without("colcon", "cmake", path=path)
    spec = replace(spec_of("rclpy", tmp_path), nodes=())
    write(render_package(spec), tmp_path / "src" / "demo")
    call(["colcon", "build"], tmp_path, {"PATH": path, "AMENT_PREFIX_PATH": sys.prefix})
    assert (tmp_path / "install/demo/share/demo/launch/demo.launch").is_file()
    assert (tmp_path / "install/demo/share/demo/urdf/rover.urdf").is_file()


@pytest.mark.long(1)
def test_smoke_test_fails_where_the_node_has_something_else(tmp_path: Path) -> None:
    """What passes for any node would prove nothing."""
    skip_without("rosmaster", path=SYSTEM)
    spec = spec_of("rospy", tmp_path)
    package = write(render_package(spec), tmp_path / "src" / "demo")
    talker = package / "scripts" / "talker.py"
    talker.write_bytes(talker.read_bytes().replace(b'"chatter"', b'"shatter"'))
    conftest = package / "test" / "conftest.py"
    conftest.write_text(conftest.read_text(encoding="utf-8").replace("= 30.0", "= 3.0"))
    command = ["python3", "-m", "pytest", "-q", "test/test_talker_node.py"]
    ended = subprocess.run(
        command,
        cwd=package,
        env={"PATH": SYSTEM, "HOME": str(tmp_path)},
        stdout=subprocess.PIPE,
        text=True,
        timeout=120,
        check=False,
    )
    assert ended.returncode == 1, ended.stdout
    assert "/chatter" in ended.stdout
