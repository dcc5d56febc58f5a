"""The package that nodes are in which have to be built, and the changes of one that exists."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.diagnostics import has_errors
from plastron_tui.generating.own_package import package_name
from plastron_tui.output.writer import write
from plastron_tui.session import Options, Session


def generate(folder: Path, text: str, *, name: str = "robot", in_place: bool = False) -> list[str]:
    """Write the files of a program, and return the codes of what is said of that."""
    options = Options(None, folder / "output", in_place=in_place)
    program = Session(text.encode(), folder / f"{name}.plastron", options, environ={})
    assert not has_errors(program.diagnostics), program.diagnostics
    plan, diagnostics = program.plan()
    result = write(plan)
    return [each.code for each in (*diagnostics, *result.diagnostics)]


def files(folder: Path) -> dict[str, str]:
    output = folder / "output"
    return {
        path.relative_to(output).as_posix(): path.read_text(encoding="utf-8")
        for path in sorted(output.rglob("*"))
        if path.is_file() and path.name != ".plastron.json"
    }


def talker(library: str, name: str = "talker") -> str:
    return (
        f"create_node '{name}' as {name} using {library}\n"
        f'create_message {name}_words of message_type String and input "hello"\n'
        f"{name} publish {name}_words to 'chatter' of message_type String at 2 hz\n"
    )


def ears(library: str, name: str = "ears") -> str:
    return (
        f"create_node '{name}' as {name} using {library}\n"
        f"subscribe {name} to 'chatter' of message_type String\n"
    )


def generated(*nodes: str) -> str:
    names = [each.split("'")[1] for each in nodes]
    return "".join(nodes) + "".join(f"generate_node {name}\n" for name in names)


SPEED = """\
create_message_type Speed with float64 value
create_node 'driver' as driver using roscpp
create_message fast of message_type Speed and input value=1
driver publish fast to 'speed' of message_type Speed
generate_node driver
"""

WRITTEN: dict[str, set[str]] = {
    generated(talker("roscpp"), ears("nodelet"), ears("rospy", "echo")): {
        "CMakeLists.txt",
        "nodelet_plugins.xml",
        "package.xml",
        "scripts/echo_sub1.py",
        "src/ears_sub1.cpp",
        "src/talker_pub.cpp",
    },
    generated(talker("rclcpp"), ears("component"), ears("rospy", "echo")): {
        "CMakeLists.txt",
        "echo_sub1.py",
        "include/robot/ears_sub1.hpp",
        "package.xml",
        "src/ears_sub1.cpp",
        "src/talker_pub.cpp",
    },
    generated(talker("roscpp"), ears("rclcpp"), ears("rclpy", "echo")): {
        "robot_ros1/CMakeLists.txt",
        "robot_ros1/package.xml",
        "robot_ros1/src/talker_pub.cpp",
        "robot_ros2/CMakeLists.txt",
        "robot_ros2/package.xml",
        "robot_ros2/scripts/echo_sub1.py",
        "robot_ros2/src/ears_sub1.cpp",
    },
    SPEED: {
        "robot/CMakeLists.txt",
        "robot/package.xml",
        "robot/src/driver_pub.cpp",
        "robot_interfaces/CMakeLists.txt",
        "robot_interfaces/README.md",
        "robot_interfaces/msg/Speed.msg",
        "robot_interfaces/package.xml",
    },
    generated(talker("rospy")): {"talker_pub.py"},
}


@pytest.mark.parametrize(("text", "names"), WRITTEN.items(), ids=range(len(WRITTEN)))
def test_nodes_that_are_built_are_in_a_package(tmp_path: Path, text: str, names: set[str]) -> None:
    assert generate(tmp_path, text) == []
    first = files(tmp_path)
    assert set(first) == names
    # A second run finds what the first one wrote.
    assert generate(tmp_path, text) == []
    assert files(tmp_path) == first


@pytest.mark.parametrize(
    ("program", "package"),
    [
        ("robot.plastron", "robot"),
        ("My Robot.plastron", "my_robot"),
        ("2.plastron", "package_2"),
        ("é.plastron", "robot_nodes"),
        ("test.plastron", "test_nodes"),
        ("rclcpp.plastron", "rclcpp_nodes"),
        ("", "robot_nodes"),
    ],
)
def test_a_package_is_called_as_its_program(program: str, package: str) -> None:
    assert package_name(program) == package


def test_handwork_in_build_files_stays(tmp_path: Path) -> None:
    text = generated(talker("rclcpp"))
    generate(tmp_path, text)
    lists = tmp_path / "output/CMakeLists.txt"
    lists.write_text("# By hand.\n" + lists.read_text(encoding="utf-8"), encoding="utf-8")
    codes = generate(tmp_path, generated(talker("rclcpp"), ears("rclcpp")))
    assert codes == ["merged-by-hand"]
    after = lists.read_text(encoding="utf-8")
    assert after.startswith("# By hand.\n")
    assert "add_executable(ears_sub1 src/ears_sub1.cpp)" in after


def test_a_node_that_is_planned_alone_leaves_the_build_files(tmp_path: Path) -> None:
    """What builds the others would go with them."""
    text = generated(talker("rclcpp"), ears("rclcpp"))
    options = Options(None, tmp_path / "output")
    program = Session(text.encode(), tmp_path / "robot.plastron", options, environ={})
    plan, _ = program.plan_of(program.generated()[:1])
    assert [each.name for each in plan.files] == ["src/talker_pub.cpp"]


PACKAGE_XML = """\
<?xml version="1.0"?>
<package format="3">
  <name>demo</name>
  <version>0.0.1</version>
  <description>Demo</description>
  <maintainer email="a@example.com">A</maintainer>
  <license>MIT</license>
  <buildtool_depend>{tool}</buildtool_depend>
</package>
"""
CATKIN = "project(demo)\nfind_package(catkin REQUIRED)\ncatkin_package()\n"


def test_a_package_that_exists_gets_a_nodelet(tmp_path: Path) -> None:
    folder = tmp_path / "demo"
    folder.mkdir()
    (folder / "package.xml").write_text(PACKAGE_XML.format(tool="catkin"), encoding="utf-8")
    (folder / "CMakeLists.txt").write_text(CATKIN, encoding="utf-8")
    put = "demo contains ears\ndemo contains talker\ngenerate_package demo\n"
    text = f"load_package 'demo' as demo\n{ears('nodelet')}{talker('roscpp')}{put}"
    generate(tmp_path, text, in_place=True)
    lists, package = (
        (folder / name).read_text(encoding="utf-8") for name in ("CMakeLists.txt", "package.xml")
    )
    plugins = (folder / "nodelet_plugins.xml").read_text(encoding="utf-8")
    assert "add_library(${PROJECT_NAME}_ears src/ears.cpp)" in lists
    assert 'name="demo/EarsNode" type="demo::EarsNode"' in plugins
    assert 'path="lib/libdemo_ears"' in plugins
    assert '<nodelet plugin="${prefix}/nodelet_plugins.xml"/>' in package
    assert package.count("<depend>") == len({"nodelet", "pluginlib", "roscpp", "std_msgs"})
    assert {"src/ears.cpp", "src/talker.cpp"} <= {
        each.relative_to(folder).as_posix() for each in folder.rglob("*")
    }
    before = (lists, package, plugins)
    generate(tmp_path, text, in_place=True)
    assert before == tuple(
        (folder / name).read_text(encoding="utf-8")
        for name in ("CMakeLists.txt", "package.xml", "nodelet_plugins.xml")
    )


def test_what_compiles_nothing_takes_no_node_that_is_built(tmp_path: Path) -> None:
    folder = tmp_path / "demo"
    folder.mkdir()
    xml = PACKAGE_XML.format(tool="python3-setuptools")
    build = "<export><build_type>ament_python</build_type></export>\n</package>"
    (folder / "package.xml").write_text(xml.replace("</package>", build), encoding="utf-8")
    (folder / "setup.py").write_text("from setuptools import setup\nsetup(name='demo')\n")
    text = f"load_package 'demo' as demo\n{talker('rclcpp')}demo contains talker\n"
    program = Session(text.encode(), tmp_path / "robot.plastron", Options(), environ={})
    assert "edit-refused" in [each.code for each in program.diagnostics]


@pytest.mark.parametrize("inner", ["", "made/"])
def test_inside_a_package_nothing_new_is_begun(tmp_path: Path, inner: str) -> None:
    (tmp_path / ".git").mkdir()
    folder = tmp_path / "demo"
    folder.mkdir()
    (folder / "package.xml").write_text(PACKAGE_XML.format(tool="catkin"), encoding="utf-8")
    (folder / "CMakeLists.txt").write_text(CATKIN, encoding="utf-8")
    text = generated(talker("roscpp"), ears("nodelet"))

    def run(text: str) -> list[str]:
        options = Options(None, folder / inner)
        program = Session(text.encode(), folder / "robot.plastron", options, environ={})
        plan, diagnostics = program.plan()
        return [each.code for each in (*diagnostics, *write(plan).diagnostics)]

    assert run(text) == []
    there = {each.relative_to(folder).as_posix() for each in folder.rglob("*") if each.is_file()}
    assert there == {
        "CMakeLists.txt",
        "nodelet_plugins.xml",
        "package.xml",
        f"{inner}.plastron.json",
        f"{inner}src/ears_sub1.cpp",
        f"{inner}src/talker_pub.cpp",
    }
    lists = (folder / "CMakeLists.txt").read_text(encoding="utf-8")
    assert f"add_executable(${{PROJECT_NAME}}_talker_pub {inner}src/talker_pub.cpp)" in lists
    assert lists.startswith("project(demo)\nfind_package(catkin REQUIRED COMPONENTS nodelet ")
    assert "demo::EarsNode" in (folder / "nodelet_plugins.xml").read_text(encoding="utf-8")
    # A second run, and one with handwork in a node, have nothing to add.
    source = folder / f"{inner}src/talker_pub.cpp"
    by_hand = f"// By hand.\n{source.read_text(encoding='utf-8')}"
    source.write_text(by_hand, encoding="utf-8")
    run(text)
    assert source.read_text(encoding="utf-8") == by_hand
    assert (folder / "CMakeLists.txt").read_text(encoding="utf-8") == lists
    # The other generation of ROS does not build here.
    assert "other-ros" in run(generated(talker("rclcpp")))


@pytest.mark.parametrize(
    ("library", "inside", "line"),
    [
        ("roscpp", "", '<node pkg="robot" type="talker_pub" name="talker" output="screen"/>'),
        ("nodelet", "", 'args="standalone robot/TalkerNode"'),
        ("nodelet", " inside 'all'", 'args="load robot/TalkerNode /all"'),
        ("rclcpp", "", '<node pkg="robot" exec="talker_pub" name="talker" output="screen"/>'),
        ("component", " inside 'all'", '<composable_node pkg="robot" plugin="robot::TalkerNode"'),
    ],
)
def test_a_launch_file_starts_nodes_of_the_program_s_own_package(
    tmp_path: Path, library: str, inside: str, line: str
) -> None:
    start = f"create_launch 'bringup' as bringup\nbringup starts talker{inside}\n"
    generate(tmp_path, f"{generated(talker(library))}{start}generate_launch bringup\n")
    made = files(tmp_path)
    [launch] = [text for name, text in made.items() if name.startswith("launch/bringup.launch")]
    assert line in launch
    # It is where the package installs it, and goes from there with what installs it.
    assert "install(\n  DIRECTORY launch\n" in made["CMakeLists.txt"]
    generate(tmp_path, generated(talker(library)))
    assert "DIRECTORY launch" not in files(tmp_path)["CMakeLists.txt"]


def test_the_package_of_nodes_that_are_not_asked_for_is_no_rest(tmp_path: Path) -> None:
    text = generated(talker("roscpp"), ears("rclcpp"))
    generate(tmp_path, text)
    options = Options(None, tmp_path / "output")
    program = Session(text.encode(), tmp_path / "robot.plastron", options, environ={})
    made = [each for each in program.generated() if each.generation.node.name == "talker"]
    _, diagnostics = program.plan_of(made)
    assert [each.code for each in diagnostics] == []


@pytest.mark.parametrize("suffix", [".cpp", ".cc", ".cxx"])
def test_what_is_built_is_the_file_that_there_is(suffix: str, tmp_path: Path) -> None:
    source = Path(__file__).parent / "nodes" / "roscpp" / "talker.cpp"
    (tmp_path / f"talker{suffix}").write_bytes(source.read_bytes())
    text = (
        f"load 'talker{suffix}' as it\nit renames topic 'chatter' to 'speech'\ngenerate_node it\n"
    )
    assert generate(tmp_path, text) == []
    found = files(tmp_path)
    assert f"src/talker{suffix}" in found
    assert f"src/talker{suffix})" in found["CMakeLists.txt"]


@pytest.mark.parametrize("file", ["src/a/talker.cpp", "include/demo/talker.hpp"])
def test_files_too_far_apart_for_the_output_folder_are_told(file: str, tmp_path: Path) -> None:
    sources = {
        "include/demo/talker.hpp": "#include <ros/ros.h>\nclass Talker {ros::NodeHandle nh_;};\n",
        "src/a/talker.cpp": (
            '#include "demo/talker.hpp"\n'
            'int main(int c, char ** v) {ros::init(c, v, "talker"); Talker t; ros::spin();}\n'
        ),
        "package.xml": "<package><name>demo</name></package>\n",
    }
    for name, source in sources.items():
        path = tmp_path / "demo" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(source, encoding="utf-8")
    text = f"load 'demo/{file}' as talker\ngenerate_node talker\n"
    options = Options(None, tmp_path / "output")
    session = Session(text.encode(), tmp_path / "robot.plastron", options, environ={})
    plan, [found] = session.plan()
    assert (found.code, plan.files) == ("outside-output", ())
    assert found.span is not None and found.help is not None
    assert text[found.span.start : found.span.end].startswith("load ")


OTHERS = {
    "types": "create_message_type robot/Speed with float64 value\n{}generate_type Speed\n",
    "a package": "{}create_package 'robot' as robot\nrobot contains ears\ngenerate_package robot\n",
    "types of a package": (
        "create_message_type robot_interfaces/Speed with float64 value\n{}"
        "create_package 'robot' as robot\nrobot contains ears\ngenerate_package robot\n"
    ),
}


@pytest.mark.parametrize("case", OTHERS)
def test_no_other_package_has_the_name_of_the_program_s_own(case: str, tmp_path: Path) -> None:
    nodes = ears("roscpp") + generated(talker("roscpp"))
    generate(tmp_path, OTHERS[case].format(nodes))
    made = files(tmp_path)
    assert "src/talker_pub.cpp" in made["robot_nodes/CMakeLists.txt"]
    assert "talker" not in made["robot/CMakeLists.txt"]


def test_the_program_s_own_package_is_none_of_ros(tmp_path: Path) -> None:
    generate(tmp_path, generated(talker("rclcpp")), name="std_msgs")
    assert "<name>std_msgs_nodes</name>" in files(tmp_path)["package.xml"]
