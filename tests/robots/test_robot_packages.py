"""Robots in packages: what is installed, what starts them, and what that needs."""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree

import pytest
from loaded_packages import KINDS, lay, run, texts

from plastron_tui.diagnostics import has_errors
from plastron_tui.ros.launch import LaunchFile, ParameterValue, SetParameter, StartedNode, items_of
from plastron_tui.ros.launch_text import Kind, Substitution
from plastron_tui.sources.launch.reader import read_launch

ROBOT = """\
create_robot 'rover' as rover
rover has_link 'base'
rover has_link 'wheel' shaped cylinder 0.1, 0.05 weighing 0.5
rover has_joint 'wheel_joint' of joint_type {type} from 'base' to 'wheel' at 0, 0.2, 0
"""
FOLLOWER = """\
rover has_link 'other'
rover has_joint 'other_joint' of joint_type continuous from 'base' to 'other' \
mimicking 'wheel_joint'
"""
DRIVER = """\
create_node '{node}' as {node}
create_message {node}_turning of message_type JointState and input name=["wheel_joint"], \
position=[0.0]
{node} publish {node}_turning to '{topic}' of message_type JointState at 10 hz
"""
NAMES = """\
driver has_parameter 'joint_names' of parameter_type string_list with default ["none"]
driver has_parameter 'base_frame' of parameter_type string with default "map"
"""
PACKAGE = (
    'create_package \'rover_demo\' as demo maintained_by "Ada <a@b.cc>" licensed_under "MIT"\n'
)
END = "demo contains rover\ngenerate_package demo\n"
LAUNCHES = {"rospy": "rover.launch", "rclpy": "rover.launch.xml"}


def driver(topic: str = "joint_states", node: str = "driver") -> str:
    return DRIVER.format(node=node, topic=topic)


def made(program: str, folder: Path, library: str, name: str = "rover_demo") -> Path:
    """Write a package, and return its folder."""
    told = run(program, folder, library)
    assert not has_errors(told), told
    return folder / "output" / name


def launch_of(package: Path, library: str) -> LaunchFile:
    file = package / "launch" / LAUNCHES[library]
    read = read_launch(file.read_bytes(), file)
    assert read.diagnostics == ()
    assert read.launch is not None
    return read.launch


def started(package: Path, library: str) -> dict[str, StartedNode]:
    nodes = items_of(launch_of(package, library).items, StartedNode)
    return {each.executable.literal or "": each for each in nodes}


def depends(package: Path) -> set[str]:
    root = ElementTree.fromstring((package / "package.xml").read_bytes())
    return {each.text or "" for each in root.findall("exec_depend")}


def settings(node: StartedNode) -> dict[str | None, object]:
    found = (each for each in node.parameters if isinstance(each, ParameterValue))
    return {each.name.literal: each.value for each in found}


@pytest.mark.parametrize("library", ["rospy", "rclpy"])
def test_a_package_publishes_what_robot_there_is(library: str, tmp_path: Path) -> None:
    program = ROBOT.format(type="fixed") + PACKAGE + END
    package = made(program, tmp_path, library)
    assert (package / "urdf/rover.urdf").is_file()
    assert not (tmp_path / "output/rover.urdf").exists()
    assert set(started(package, library)) == {"robot_state_publisher"}
    launch = launch_of(package, library)
    if library == "rospy":
        [parameter] = (each.parameter for each in items_of(launch.items, SetParameter))
    else:
        [parameter] = started(package, library)["robot_state_publisher"].parameters
    assert isinstance(parameter, ParameterValue)
    assert parameter.is_text
    assert parameter.name.literal == "robot_description"
    [content] = getattr(parameter.value, "parts", ())
    assert isinstance(content, Substitution)
    assert content.kind is Kind.CONTENT
    assert str(content.argument) == "$(find-pkg-share rover_demo)/urdf/rover.urdf"
    assert depends(package) >= {"robot_state_publisher"}
    assert "joint_state_publisher" not in depends(package)
    build = "setup.py" if (package / "setup.py").exists() else "CMakeLists.txt"
    assert "urdf" in (package / build).read_text()


@pytest.mark.parametrize("library", ["rospy", "rclpy"])
@pytest.mark.parametrize(
    ("nodes", "wanted", "published"),
    [
        ("", {"joint_state_publisher"}, "/joint_states"),
        (driver(), {"driver"}, "/joint_states"),
        (driver("/joint_states"), {"driver"}, "/joint_states"),
        (driver("left/joint_states"), {"driver"}, "/left/joint_states"),
        # What a joint shall do is not where it is.
        (driver("joint_commands"), {"joint_state_publisher"}, "/joint_states"),
        (
            driver("left/joint_states") + driver("right/joint_states", "other"),
            {"driver", "other", "joint_state_publisher"},
            "/joint_states",
        ),
    ],
)
def test_somebody_says_where_joints_are(
    nodes: str, wanted: set[str], published: str, library: str, tmp_path: Path
) -> None:
    inside = "".join(f"demo contains {each}\n" for each in ("driver", "other") if each in nodes)
    program = ROBOT.format(type="continuous") + nodes + PACKAGE + inside + END
    package = made(program, tmp_path, library)
    nodes_there = started(package, library)
    names = {name.removesuffix(".py") for name in nodes_there}
    assert names == {*wanted, "robot_state_publisher"}
    assert ("joint_state_publisher" in depends(package)) == ("joint_state_publisher" in wanted)
    remaps = nodes_there["robot_state_publisher"].remaps
    heard = {str(each.old): str(each.new) for each in remaps}.get("joint_states", "/joint_states")
    assert heard == published
    if {"driver", "joint_state_publisher"} <= wanted:
        sources = settings(nodes_there["joint_state_publisher"])["source_list"]
        assert sources == ("/left/joint_states", "/right/joint_states")


@pytest.mark.parametrize("library", ["rospy", "rclpy"])
def test_nodes_get_the_names_of_joints_and_root(library: str, tmp_path: Path) -> None:
    program = ROBOT.format(type="continuous") + FOLLOWER + driver() + NAMES
    package = made(program + PACKAGE + "demo contains driver\n" + END, tmp_path, library)
    node = next(each for name, each in started(package, library).items() if "driver" in name)
    assert settings(node) == {"joint_names": ("wheel_joint",), "base_frame": "base"}


def test_what_a_launch_file_starts_is_not_started_twice(tmp_path: Path) -> None:
    bringup = "create_launch 'bringup' as bringup\nbringup starts driver\n"
    bringup += "bringup includes 'rover_demo/rover.launch.xml'\n"
    program = ROBOT.format(type="continuous") + driver() + PACKAGE + "demo contains driver\n"
    package = made(program + bringup + "demo contains bringup\n" + END, tmp_path, "rclpy")
    assert set(started(package, "rclpy")) == {"robot_state_publisher"}


def test_nodes_of_other_packages_are_left_to_these(tmp_path: Path) -> None:
    other = PACKAGE.replace("rover_demo", "rover_nodes").replace("as demo", "as nodes")
    program = ROBOT.format(type="continuous") + driver() + PACKAGE + other
    program += "nodes contains driver\ngenerate_package nodes\n"
    package = made(program + END, tmp_path, "rospy")
    assert set(started(package, "rospy")) == {"robot_state_publisher"}
    assert "rover_nodes" not in depends(package)


def test_a_node_in_no_package_is_told(tmp_path: Path) -> None:
    program = ROBOT.format(type="continuous") + driver() + "generate_node driver\n" + PACKAGE + END
    told = run(program, tmp_path, "rclpy")
    assert [str(each.code) for each in told] == ["in-no-package"]
    assert not has_errors(told)


def test_a_launch_file_of_its_name_is_a_mistake(tmp_path: Path) -> None:
    program = ROBOT.format(type="fixed") + PACKAGE
    program += "create_launch 'rover' as up\nup starts 'other/eye'\ndemo contains up\n" + END
    told = run(program, tmp_path, "rospy")
    assert [str(each.code) for each in told] == ["bad-package-file"]
    assert not (tmp_path / "output").exists()


def test_meshes_of_other_packages_are_depended_on(tmp_path: Path) -> None:
    mesh = "rover has_link 'body' shaped mesh \"package://other_parts/meshes/body.stl\"\n"
    joint = "rover has_joint 'body_joint' of joint_type fixed from 'base' to 'body'\n"
    package = made(ROBOT.format(type="fixed") + mesh + joint + PACKAGE + END, tmp_path, "rclpy")
    assert "other_parts" in depends(package)


def test_python_launch_files_say_the_same(tmp_path: Path) -> None:
    (tmp_path / "plastron.yaml").write_text("launch: python\n")
    program = ROBOT.format(type="continuous") + driver() + PACKAGE + "demo contains driver\n" + END
    package = made(program, tmp_path, "rclpy")
    file = package / "launch/rover.launch.py"
    read = read_launch(file.read_bytes(), file)
    assert read.diagnostics == ()
    assert read.launch is not None
    (tmp_path / "plastron.yaml").unlink()
    other = made(program, tmp_path / "xml", "rclpy")
    assert read.launch == launch_of(other, "rclpy")


@pytest.mark.parametrize("kind", KINDS)
def test_a_robot_is_put_into_a_loaded_package_and_taken_out(kind: str, tmp_path: Path) -> None:
    library, files = KINDS[kind]
    package = lay(tmp_path, files)
    before = texts(package)
    load = "load_package 'demo' as demo\n"
    for _ in range(2):
        assert (
            run(ROBOT.format(type="continuous") + load + END, tmp_path, library, in_place=True)
            == ()
        )
        after = texts(package)
        new = {"urdf/rover.urdf", f"launch/{LAUNCHES[library]}"}
        assert set(after) == {*before, *new}
        assert depends(package) >= {"robot_state_publisher", "joint_state_publisher"}
        build = "setup.py" if kind == "ament_python" else "CMakeLists.txt"
        assert b"urdf" in after[build]
        assert b"launch" in after[build]
    out = f"{load}demo no_longer_contains 'rover'\ngenerate_package demo\n"
    assert {str(x.code) for x in run(out, tmp_path, library, in_place=True)} == {"file-stays"}
    assert texts(package) == {**before, **{name: after[name] for name in new}}


@pytest.mark.parametrize("in_place", [True, False])
def test_a_robot_of_a_loaded_package_is_changed_where_it_is(in_place: bool, tmp_path: Path) -> None:
    library, files = KINDS["ament_python"]
    urdf = '<robot name="rover">\n  <link name="base"/>  <!-- odd -->\n</robot>\n'
    package = lay(tmp_path, {**files, "model/rover.urdf": urdf})
    program = (
        "load_package 'demo' as demo\nload_robot 'demo/model/rover.urdf' as rover\n"
        "rover has_link 'eye'\n"
        "rover has_joint 'eye_joint' of joint_type fixed from 'base' to 'eye'\n"
    )
    for _ in range(2):
        assert run(program + END, tmp_path, library, in_place=in_place) == ()
        found = texts(package if in_place else tmp_path / "output/demo")
        assert found["model/rover.urdf"].count(b'"eye"') == 2
        assert b"odd" in found["model/rover.urdf"]
        assert b"model/rover.urdf" in found["launch/rover.launch.xml"]
        assert "urdf/rover.urdf" not in found


def test_a_robot_that_is_there_is_not_written_over(tmp_path: Path) -> None:
    library, files = KINDS["ament_cmake"]
    package = lay(tmp_path, {**files, "urdf/rover.urdf": '<robot name="mine"/>\n'})
    before = texts(package)
    program = ROBOT.format(type="fixed") + "load_package 'demo' as demo\n" + END
    told = run(program, tmp_path, library, in_place=True)
    assert [str(each.code) for each in told] == ["file-conflict"]
    assert texts(package) == before


XACRO = """\
<robot name="rover" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="parts.xacro"/>
  <xacro:include filename="$(find other)/more.xacro"/>
  <link name="base"/>
</robot>
"""


@pytest.mark.parametrize("library", ["rospy", "rclpy"])
@pytest.mark.parametrize("name", ["rover.urdf.xacro", "rover.urdf"])
def test_macros_are_expanded_where_the_robot_starts(
    name: str, library: str, tmp_path: Path
) -> None:
    (tmp_path / name).write_text(XACRO)
    told = run(f"load_robot '{name}' as rover\n{PACKAGE}{END}", tmp_path, library)
    assert not has_errors(told)
    [left] = [each for each in told if each.code == "not-copied"]
    assert "parts.xacro" in left.message
    package = tmp_path / "output/rover_demo"
    assert (package / "urdf" / name).read_text() == XACRO
    assert (
        f"xacro $(find{'' if library == 'rospy' else '-pkg-share'} rover_demo)/urdf/{name}"
        in (package / "launch" / LAUNCHES[library]).read_text()
    )
    assert depends(package) >= {"xacro", "robot_state_publisher"}


def test_humble_has_no_words_for_the_content_of_a_file(tmp_path: Path) -> None:
    (tmp_path / "plastron.yaml").write_text("distribution: humble\n")
    package = made(ROBOT.format(type="fixed") + PACKAGE + END, tmp_path, "rclpy")
    text = (package / "launch/rover.launch.xml").read_text()
    assert "$(command 'cat $(find-pkg-share rover_demo)/urdf/rover.urdf')" in text


@pytest.mark.parametrize(
    ("inside", "library", "file"),
    [
        ("demo contains rover\n", "rospy", "rover_demo/rover.launch"),
        ("demo contains rover\n", "rclpy", "rover_demo/rover.launch.xml"),
        ("", "rclpy", "PACKAGE/rover.launch.xml"),
    ],
)
def test_a_robot_is_started_by_what_its_package_has(
    inside: str, library: str, file: str, tmp_path: Path
) -> None:
    program = ROBOT.format(type="fixed") + PACKAGE + inside
    program += "create_launch 'bringup' as bringup\n"
    [told] = run(f"{program}bringup starts rover\n", tmp_path, library)
    assert told.code == "unknown-node"
    assert told.help is not None
    assert f"`includes '{file}'`" in told.help
    if inside:
        write = "demo contains bringup\ngenerate_package demo\n"
        assert run(f"{program}bringup includes '{file}'\n{write}", tmp_path, library) == ()


def test_the_copy_of_a_package_has_a_robot_as_it_is_changed(tmp_path: Path) -> None:
    library, files = KINDS["ament_cmake"]
    urdf = '<robot name="rover">\n  <link name="base"/>\n</robot>\n'
    lay(tmp_path, {**files, "urdf/rover.urdf": urdf})
    program = (
        "load_package 'demo' as demo\nload_robot 'demo/urdf/rover.urdf' as rover\n"
        "rover has_link 'eye'\n"
        "rover has_joint 'eye_joint' of joint_type fixed from 'base' to 'eye'\n"
        "generate_robot rover\ngenerate_package demo\n"
    )
    assert run(program, tmp_path, library) == ()
    made_files = texts(tmp_path / "output")
    assert b'"eye"' in made_files["demo/urdf/rover.urdf"]
    assert made_files["demo/urdf/rover.urdf"] == made_files["rover.urdf"]


def test_a_robot_of_a_package_is_not_written_beside_it(tmp_path: Path) -> None:
    program = ROBOT.format(type="fixed") + "generate_robot rover\n" + PACKAGE + END
    made(program, tmp_path, "rospy")
    assert not (tmp_path / "output/rover.urdf").exists()


@pytest.mark.parametrize("library", ["roscpp", "rclcpp"])
def test_a_package_for_what_is_built_has_the_robot_too(library: str, tmp_path: Path) -> None:
    program = ROBOT.format(type="continuous") + driver() + NAMES
    assert run(f"{program}generate_node driver\ngenerate_robot rover\n", tmp_path, library) == ()
    package = tmp_path / "output"
    assert (package / "urdf/rover.urdf").is_file()
    assert not (package / "rover.urdf").exists()
    nodes = started(package, "rospy" if library == "roscpp" else "rclpy")
    assert set(nodes) == {"robot_state_publisher", "driver_pub"}
    assert settings(nodes["driver_pub"])["joint_names"] == ("wheel_joint",)
    assert "urdf" in (package / "CMakeLists.txt").read_text()
    assert depends(package) >= {"robot_state_publisher"}


def test_a_robot_is_started_by_no_name_of_its_own(tmp_path: Path) -> None:
    program = ROBOT.format(type="fixed") + PACKAGE + "demo contains rover as 'other'\n"
    [told] = run(program, tmp_path, "rospy")
    assert told.code == "bad-package-file"
    assert told.help == "leave out `as 'other'`"


def test_what_a_robot_leaves_in_its_package_is_told(tmp_path: Path) -> None:
    program = ROBOT.format(type="fixed") + PACKAGE
    package = made(program + END, tmp_path, "rclpy")
    told = run(f"{program}generate_package demo\n", tmp_path, "rclpy")
    left = {each.file.name for each in told if each.code == "file-stays" and each.file}
    assert left == {"rover.launch.xml", "rover.urdf"}
    assert "urdf" not in (package / "CMakeLists.txt").read_text()


TWO = """\
create_robot 'arm' as arm
arm has_link 'base'
arm has_link 'hand'
arm has_joint 'elbow' of joint_type continuous from 'base' to 'hand'
"""


@pytest.mark.parametrize(
    ("joint", "topic", "of_rover", "of_arm"),
    [
        ("wheel_joint", "joint_states", {"driver"}, {"joint_state_publisher"}),
        ("elbow", "joint_states", {"joint_state_publisher"}, {"driver"}),
        ("elbow", "rover/joint_states", {"joint_state_publisher"}, {"driver"}),
        ("", "arm/joint_states", {"joint_state_publisher"}, {"driver"}),
        ("", "joint_states", {"driver"}, {"driver"}),
    ],
)
def test_each_robot_of_a_package_has_its_own_nodes(
    joint: str, topic: str, of_rover: set[str], of_arm: set[str], tmp_path: Path
) -> None:
    program = ROBOT.format(type="continuous") + TWO + driver(topic)
    program = program.replace('name=["wheel_joint"], ', f'name=["{joint}"], ' if joint else "")
    inside = "demo contains driver\ndemo contains arm\n"
    told = run(program + PACKAGE + inside + END, tmp_path, "rclpy")
    assert not has_errors(told), told
    for name, wanted in (("rover", of_rover), ("arm", of_arm)):
        text = (tmp_path / f"output/rover_demo/launch/{name}.launch.xml").read_text()
        nodes = {each for each in ("driver", "joint_state_publisher") if f'exec="{each}' in text}
        assert (name, nodes) == (name, wanted)
    unsure = [each for each in told if each.code == "unclear-robot"]
    assert [each.severity.value for each in unsure] == ["warning"] * (of_rover == of_arm)
