"""What `plastron run` starts of a launch file: command lines, and why there are none."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.diagnostics import Severity
from plastron_tui.ros.installations import Origin
from plastron_tui.ros.parameter_values import yaml_text
from plastron_tui.runtime import xacro
from plastron_tui.runtime.environment import Environment
from plastron_tui.runtime.launch import NodeFile
from plastron_tui.runtime.launch_run import Prepared, prepare
from plastron_tui.runtime.xacro import Expanded
from plastron_tui.sources.launch.reader import is_launch_file, read_launch
from plastron_tui.trust import TrustStore

MANIFEST = """<package format="3"><name>{}</name><version>0.1.0</version>
<description>d</description><maintainer email="a@b.cc">a</maintainer><license>MIT</license>
</package>
"""
SETUP = """from setuptools import setup
setup(name="demo", packages=["demo"],
      entry_points={"console_scripts": ["talker = demo.talker:main"]})
"""


@pytest.fixture
def project(tmp_path: Path) -> Path:
    demo, plain = tmp_path / "src/demo", tmp_path / "src/plain"
    for folder in (demo / "launch", demo / "config", plain / "scripts", tmp_path / "python/bin"):
        folder.mkdir(parents=True)
    (demo / "package.xml").write_text(MANIFEST.format("demo"))
    (demo / "setup.py").write_text(SETUP)
    (demo / "config/values.yaml").write_text("/**:\n  ros__parameters: {}\n")
    (plain / "package.xml").write_text(MANIFEST.format("plain"))
    (plain / "CMakeLists.txt").write_text("")
    (plain / "scripts/camera.py").write_text("#!/usr/bin/env python3\n")
    for prefix in ("install/built", "python"):
        binary = tmp_path / prefix / "lib/built/driver"
        binary.parent.mkdir(parents=True)
        binary.write_text("#!/bin/sh\n")
        binary.chmod(0o755)
    return tmp_path


def _prepared(
    project: Path,
    words: str,
    name: str = "x.launch.xml",
    origin: Origin = Origin.EXTRA,
    **arguments: str,
) -> Prepared:
    file = project / "src/demo/launch" / name
    file.write_text(f"<launch>{words}</launch>" if name.endswith("xml") else words)
    read = read_launch(file.read_bytes(), file)
    assert read.launch is not None
    environment = Environment(origin, 2, "kilted", project / "python/bin/python3")
    return prepare(read.launch, file, arguments, environment, {})


def _one(prepared: Prepared) -> NodeFile:
    assert [each.message for each in prepared.diagnostics] == []
    (node,) = prepared.nodes
    return node


def test_nodes_get_their_names_and_parameters(project: Path) -> None:
    node = _one(
        _prepared(
            project,
            """<arg name="robot" default="rover"/>
            <group><push_ros_namespace namespace="$(var robot)"/>
            <node pkg="demo" exec="talker" name="speaker" namespace="base" args="--loud 'a b'">
            <remap from="chatter" to="/words"/>
            <param from="$(find-pkg-share demo)/config/values.yaml"/>
            <param name="speed" value="0.5"/><param name="word" value="$(var robot)"/>
            </node></group>""",
            robot="tank",
        )
    )
    demo = project / "src/demo"
    assert (node.command[0], node.command[-1]) == (
        str(project / "python/bin/python3"), "demo.talker:main",
    )  # fmt: skip
    assert node.folders == (("PYTHONPATH", demo),)
    assert node.full_name == "/tank/base/speaker"
    assert node.title == "tank/base/speaker"
    assert node.arguments == (
        *("--loud", "a b", "--ros-args", "-r", "__node:=speaker", "-r", "__ns:=/tank/base"),
        *("-r", "chatter:=/words", "--params-file", str(demo / "config/values.yaml")),
        *("-p", "speed:=0.5", "-p", 'word:="tank"'),
    )


VALUE, FILE = '<param name="speed" value="1"/>', '<param from="{}/config/values.yaml"/>'


@pytest.mark.parametrize(
    ("around", "within", "expected"),
    [
        ("", FILE + VALUE, ["--params-file", "{}/config/values.yaml", "-p", "speed:=1"]),
        ("", VALUE + FILE, ["-p", "speed:=1", "--params-file", "{}/config/values.yaml"]),
        (
            '<set_parameter name="speed" value="2"/>',
            FILE + VALUE,
            ["-p", "speed:=2", "--params-file", "{}/config/values.yaml", "-p", "speed:=1"],
        ),
    ],
)
def test_parameters_are_given_in_the_order_in_which_they_are_written(
    project: Path, around: str, within: str, expected: list[str]
) -> None:
    demo = project / "src/demo"
    words = f'{around}<node pkg="demo" exec="talker">{within.format(demo)}</node>'
    arguments = _one(_prepared(project, words)).arguments
    assert arguments == ("--ros-args", *(each.format(demo) for each in expected))


@pytest.mark.parametrize(
    ("package", "executable", "command"),
    [
        ("plain", "camera.py", ("python/bin/python3", "src/plain/scripts/camera.py")),
        ("plain", "camera", ("python/bin/python3", "src/plain/scripts/camera.py")),
        # What colcon has built comes before what is installed with ROS.
        ("built", "driver", ("install/built/lib/built/driver",)),
    ],
)
def test_executables_are_found(
    project: Path, package: str, executable: str, command: tuple[str, ...]
) -> None:
    node = _one(_prepared(project, f'<node pkg="{package}" exec="{executable}"/>'))
    assert node.command == tuple(str(project / each) for each in command)
    assert node.arguments == ()


def test_yaml_and_python_start_the_same(project: Path) -> None:
    xml = _prepared(project, '<node pkg="demo" exec="talker" name="a" namespace="b"/>')
    yaml = "launch:\n- node: {pkg: demo, exec: talker, name: a, namespace: b}\n"
    python = (
        "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n"
        "def generate_launch_description():\n    return LaunchDescription([\n"
        "        Node(package='demo', executable='talker', name='a', namespace='b')])\n"
    )
    assert _one(_prepared(project, yaml, "x.launch.yaml")) == _one(xml)
    assert _one(_prepared(project, python, "x.launch.py")) == _one(xml)


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("", "the launch file starts no node"),
        ('<node pkg="dem" exec="talker"/>', "the package `dem` is not found"),
        ('<node pkg="../demo" exec="talker"/>', "the package `../demo` is not found"),
        (
            '<node pkg="demo" exec="talkr"/>',
            "the package `demo` has no executable `talkr`",
        ),
        (
            '<node pkg="plain" exec="../../demo/setup.py"/>',
            "the package `plain` has no executable `../../demo/setup.py`",
        ),
        ('<arg name="x"/><node pkg="demo" exec="talker"/>', "the argument `x` has no value"),
        (
            '<node pkg="demo" exec="talker" if="$(eval 1)"/>',
            "what hangs on a condition is left out: `$(eval 1)` is not known here",
        ),
        (
            '<node pkg="demo" exec="talker" launch-prefix="gdb"/>',
            "`run` does not do what `launch-prefix` asks for",
        ),
        (
            '<node pkg="demo" exec="talker" args="\'a"/>',
            "`args` has a quote that is not closed",
        ),
        (
            '<node pkg="demo" exec="talker"><param from="no.yaml"/></node>',
            "the parameter file `no.yaml` is not found",
        ),
        (
            '<load_composable_node target="c"><composable_node pkg="demo" plugin="demo::A"/>'
            "</load_composable_node>",
            "`demo::A` is a component, and the file does not start its container `c`",
        ),
        (
            '<include file="/etc/passwd"/>',
            "`/etc/passwd` is left out: it is neither in the project nor installed",
        ),
        ('<executable cmd="ls"/>', "`<executable>` is not understood, and left out"),
    ],
)
def test_what_cannot_be_started_is_told_and_nothing_is(
    project: Path, words: str, message: str
) -> None:
    prepared = _prepared(project, f"{words}\n")
    assert prepared.nodes == ()
    assert message in [each.message for each in prepared.diagnostics]
    assert all(each.file is not None for each in prepared.diagnostics)


def test_why_a_component_is_not_started_is_said(project: Path) -> None:
    words = (
        '<load_composable_node target="c"><composable_node pkg="demo" plugin="demo::A"/>'
        "</load_composable_node>"
    )
    (found,) = _prepared(project, words).diagnostics
    assert found.help is not None
    assert "C++" in found.help
    assert "ros2 launch" in found.help


@pytest.mark.parametrize(
    ("origin", "remedy"),
    [
        (Origin.EXTRA, "has no such nodes: source a whole ROS 2"),
        (Origin.SOURCED, "`sudo apt install ros-kilted-robot-state-publisher` installs it"),
    ],
)
def test_how_a_package_of_ros_gets_there_is_said(
    project: Path, origin: Origin, remedy: str
) -> None:
    words = '<node pkg="robot_state_publisher" exec="robot_state_publisher"/>'
    (found,) = _prepared(project, words, origin=origin).diagnostics
    assert (found.help or "").endswith(remedy)


def test_near_names_are_offered(project: Path) -> None:
    (found,) = _prepared(project, '<node pkg="demo" exec="talkr"/>').diagnostics
    assert found.help == "did you mean `talker`?"
    assert found.span is not None
    (found,) = _prepared(project, '<node pkg="demo" exec="talker"/>', x="1").diagnostics
    assert found.severity is Severity.WARNING


@pytest.mark.parametrize(
    ("name", "is_launch"),
    [
        ("a.launch", True),
        ("a.launch.xml", True),
        ("a_launch.py", True),
        ("a.launch.yml", True),
        ("a.plastron", False),
        ("package.xml", False),
        ("a.py", False),
    ],
)
def test_launch_files_are_known_by_their_names(name: str, is_launch: bool) -> None:
    assert is_launch_file(Path(name)) is is_launch


@pytest.mark.parametrize(
    ("command", "given", "help_"),
    [
        ("xacro $(find-pkg-share demo)/r.xacro name:='a b'", (("name", "a b"),), None),
        ("xacro $(find-pkg-share demo)/r.xacro", (), "are not expanded: no"),
        ("xacro /etc/hosts", None, "`hosts` is neither in the project nor installed"),
        ("xacro $(find-pkg-share demo)/none.xacro", None, "`none.xacro` cannot be read"),
        ("touch $(find-pkg-share demo)/out", None, ""),
        ("xacro $(find-pkg-share demo)/r.xacro -o out", None, ""),
    ],
)
def test_a_robot_is_expanded_where_the_project_is_trusted(
    project: Path,
    monkeypatch: pytest.MonkeyPatch,
    command: str,
    given: tuple[tuple[str, str], ...] | None,
    help_: str | None,
) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(project / "state"))
    (project / "src/demo/r.xacro").write_text("<robot/>")
    calls: list[object] = []

    def expand(*arguments: object) -> Expanded:
        calls.append(arguments[-1])
        return Expanded(b"<robot name='r'/>") if arguments[-1] else Expanded(None, "no")

    monkeypatch.setattr(xacro, "expand", expand)
    words = command.replace("'", "\\'")
    words = f"""<node pkg="demo" exec="talker">
      <param name="robot_description" type="str" value="$(command '{words}')"/></node>"""
    is_untrusted = any(
        "plastron trust" in (x.help or "") for x in _prepared(project, words).diagnostics
    )
    assert is_untrusted == (help_ is None or (".xacro" in command and "-o" not in command))
    assert calls == []
    TrustStore().add(project / "src/demo")
    prepared = _prepared(project, words)
    assert calls == ([] if given is None else [given])
    assert not (project / "src/demo/out").exists()
    if help_ is None:
        assert "robot_description:=" + yaml_text("<robot name='r'/>") in _one(prepared).arguments
    else:
        [told] = prepared.diagnostics
        assert help_ in (told.help or "")
