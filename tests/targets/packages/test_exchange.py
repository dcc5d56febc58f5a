"""What `plastron generate` writes, built and run by the tools of its ROS alone: no Plastron."""

from __future__ import annotations

import json
import shutil
import subprocess
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import pytest
from catkin_pkg.packages import find_packages
from machine import find_ros, graph_environ
from processes import PLASTRON, Process, processes
from ros_workspaces import SCRIPTS, SYSTEM, call, complete_ros2, skip_without

pytestmark = [pytest.mark.live]

TYPES = {
    "rclpy": """\
create_message_type Axle with float64 angle default 0.5, uint8 OK=1, string<=9 label default "left"
create_message_type WheelSpeed with float64 left, float64[2] pair, Axle[<=3] axles, Axle main
create_action_type Drive with float64 distance returning bool arrived reporting float64 left
""",
    "rospy": """\
create_message_type Axle with float64 angle, uint8 OK = 1, string label
create_message_type WheelSpeed with float64 left, float64[2] pair, Axle[] axles, Axle main
create_action_type Drive with float64 distance returning bool arrived reporting float64 left
""",
}
NODES = """\
create_service_type SetLevel with Axle axle, string name returning bool success, string message

create_node 'wheels' as wheels
create_message turning of message_type WheelSpeed and input left=4.5, main.label="front"
wheels publish turning to 'wheel_speed' of message_type WheelSpeed at 10 hz
wheels provides_service 'set_level' of service_type SetLevel answering success=True, message="done"
wheels provides_action 'drive' of action_type Drive
create_node 'watcher' as watcher
subscribe watcher to 'wheel_speed' of message_type WheelSpeed
watcher client_requests 'set_level' of service_type SetLevel with input name="hi"
watcher sends_goal to 'drive' of action_type Drive with input distance=1.5

create_launch 'bringup' as bringup
bringup starts wheels as 'rear' in 'car' remapping 'wheel_speed' to '/speeds'
bringup starts watcher in 'car' remapping 'wheel_speed' to '/speeds'
create_package 'rover' as rover maintained_by "Ann <ann@example.org>" licensed_under "Apache-2.0"
rover contains wheels
rover contains watcher
rover contains bringup
generate_package rover

create_launch 'all' as all
all includes 'rover/FILE'
create_package 'rover_start' as start maintained_by "Ann <ann@example.org>" licensed_under "MIT"
start contains all
generate_package start
"""
PACKAGES = {
    "rclpy": {"rover": "ament_python", "rover_interfaces": "ament_cmake",
              "rover_start": "ament_cmake"},
    "rospy": {"rover": "catkin", "rover_start": "catkin"},
}  # fmt: skip
TOGETHER = {"rover": "ament_cmake", "rover_start": "ament_cmake"}
LAUNCH = {"rclpy": "bringup.launch.xml", "rospy": "bringup.launch"}


def generate(library: str, folder: Path, packages: Iterable[str], types: str = "") -> Path:
    """Generate the program, and return the source folder of a workspace with a copy of it.

    Args:
        library: the client library.
        folder: where the workspace is made.
        packages: the packages that it is to have.
        types: what stands before the names of types where they are made.
    """
    text = TYPES[library] + NODES.replace("FILE", LAUNCH[library])
    text = text.replace("_type ", f"_type {types}") if types else text
    for kind in ("message", "service", "action"):
        text = text.replace(f"of {kind}_type {types}", f"of {kind}_type ")
    written = folder / "written"
    written.mkdir()
    (written / "rover.plastron").write_text(text)
    command = [PLASTRON, "generate", "rover.plastron", "--target", library, "-o", "out"]
    call(command, written, {"PATH": SYSTEM})
    source = folder / "ws" / "src"
    assert {each.name for each in (written / "out").iterdir() if each.is_dir()} == set(packages)
    for name in packages:
        shutil.copytree(written / "out" / name, source / name)
    shutil.rmtree(written)
    for file in source.rglob("*"):
        assert file.is_dir() or b"plastron" not in file.read_bytes().lower(), file
    return source


def check_style(source: Path, kinds: Mapping[str, str]) -> None:
    """Let the readers and linters of ROS read the packages, given by name with their kinds."""
    found = sorted(find_packages(str(source)).values(), key=lambda each: each.name)
    assert {each.name: each.get_build_type() for each in found} == kinds
    path = {"PATH": f"{SCRIPTS}:{SYSTEM}"}
    listed = call(["colcon", "list"], source.parent, path).splitlines()
    assert listed == [f"{name}\tsrc/{name}\t(ros.{kind})" for name, kind in kinds.items()]
    skip_without("xmllint", path=SYSTEM)
    xml = [*source.glob("*/package.xml"), *source.glob("*/launch/*")]
    assert len(xml) == len(kinds) + 2
    assert call(["xmllint", "--noout", *xml], source, path) == ""
    assert "No problems found" in call(["ament_lint_cmake", source], source, path)
    for each in found:
        # What ament_lint_auto does of them: each with its defaults.
        asked = {depend.name.removeprefix("ament_cmake_") for depend in each.test_depends}
        for name in asked & {"copyright", "flake8", "pep257"}:
            call([f"ament_{name}", source / each.name], source, path)
    if set(kinds.values()) == {"catkin"}:
        told = call(["catkin_lint", "-W2", "--strict", "--offline", source], source, path)
        assert "found 0 problems" in told


@pytest.mark.long(1)
@pytest.mark.parametrize("are_together", [False, True], ids=["types apart", "types together"])
def test_installed_executables_exchange_own_types(are_together: bool, tmp_path: Path) -> None:
    pytest.importorskip("rclpy")
    wheels = complete_ros2(tmp_path)
    skip_without("colcon", "cmake", "make", "c++", path=wheels["PATH"])
    kinds = TOGETHER if are_together else PACKAGES["rclpy"]
    types = "rover" if are_together else "rover_interfaces"
    source = generate("rclpy", tmp_path, kinds, "rover/" if are_together else "")
    check_style(source, kinds)
    workspace = source.parent
    told = call(["colcon", "build"], workspace, wheels)
    assert f"Summary: {len(kinds)} packages finished" in told
    installed = workspace / "install"
    assert (installed / "rover_start/share/rover_start/launch/all.launch.xml").is_file()
    assert (installed / "rover/share/rover/launch" / LAUNCH["rclpy"]).is_file()
    environ = {
        **wheels,
        **graph_of(tmp_path),
        "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST",
        "RMW_IMPLEMENTATION": "rmw_fastrtps_cpp",
    }
    with processes() as started:
        for name in ("wheels", "watcher"):
            words = f". install/setup.sh && exec install/rover/lib/rover/{name}"
            node = Process(["sh", "-c", f"cd {workspace} && {words}"], environ, tmp_path / name)
            started.append(node)
        serving, asking = started
        asking.wait_to_print(f"wheel_speed: {types}.msg.WheelSpeed(left=4.5,")
        asking.wait_to_print(f"main={types}.msg.Axle(angle=0.5, label='front')")
        asking.wait_to_print("SetLevel_Response(success=True, message='done')")
        asking.wait_to_print(f"drive: succeeded: {types}.action.Drive_Result")
        serving.wait_to_print("angle=0.5, label='left'), name='hi'")
        serving.wait_to_print("Drive_Goal(distance=1.5)")
        assert [each.interrupt() for each in started] == [0, 0]
    call(["colcon", "test", "--packages-select", "rover"], workspace, wheels)
    told = call(["colcon", "test-result", "--all"], workspace, wheels)
    # Those of the style and of the two nodes; those of the nodes, which CTest counts as well.
    assert "Summary: 4 tests, 0 errors, 0 failures, 0 skipped" in told


def graph_of(folder: Path) -> dict[str, str]:
    """Return the variables that keep nodes in a graph of the test's own."""
    return {name: text for name, text in graph_environ(folder).items() if name.startswith("ROS_")}


@pytest.mark.long(1)
def test_roslaunch_starts_nodes_that_exchange_own_types(tmp_path: Path) -> None:
    find_ros(1)
    skip_without("catkin_make", "roslaunch", "rosmaster", "rostopic", path=SYSTEM)
    source = generate("rospy", tmp_path, PACKAGES["rospy"])
    check_style(source, PACKAGES["rospy"])
    workspace = source.parent
    system = {"PATH": SYSTEM, "ROS_IP": "127.0.0.1", **graph_of(tmp_path)}
    call(["catkin_make", "-j2"], workspace, system)

    def sourced(words: str) -> list[str]:
        return ["sh", "-c", f"cd {workspace} && . devel/setup.sh && exec {words}"]

    names = call(sourced("roslaunch --nodes rover_start all.launch"), workspace, system).split()
    said = nodes_of(source / "rover" / "launch" / LAUNCH["rospy"])
    assert sorted(names) == said == ["/car/rear", "/car/watcher"]
    port = system["ROS_MASTER_URI"].rpartition(":")[2]
    with processes() as started:
        command = sourced(f"roslaunch -p {port} rover_start all.launch")
        launched = Process(command, system, tmp_path / "launched")
        started.append(launched)
        launched.wait_to_print("wheel_speed: left: 4.5")
        launched.wait_to_print('label: "front"')
        launched.wait_to_print("set_level: success: True")
        launched.wait_to_print("drive: succeeded")
        told = call(sourced("rostopic echo -n 1 /speeds"), workspace, system)
        assert told.startswith("left: 4.5\n")
        assert call(sourced("rostopic type /speeds"), workspace, system) == "rover/WheelSpeed\n"
        assert launched.interrupt() == 0
    call(["catkin_make", "-j2", "run_tests"], workspace, system)
    told = call(["catkin_test_results", "build"], workspace, system)
    assert "4 tests, 0 errors, 0 failures" in told


def nodes_of(launch: Path) -> list[str]:
    """Return the names of the nodes that Plastron says a launch file starts."""
    command = [PLASTRON, "graph", "--format", "json", launch]
    graph: dict[str, Any] = json.loads(subprocess.check_output(command, timeout=60))
    return sorted(each["name"] for each in graph["nodes"])
