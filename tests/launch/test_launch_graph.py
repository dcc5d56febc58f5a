"""The graph of launch files that include others, in XML, YAML and Python."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.boundary import find_boundary
from plastron_tui.diagnostics import Severity
from plastron_tui.project.launch_graph import launch_graph
from plastron_tui.ros.installations import Origin
from plastron_tui.runtime.environment import Environment
from plastron_tui.runtime.launch_packages import find_packages

INCLUDED = {
    "in.launch.xml": '<launch><node pkg="demo" exec="eye" name="eye"/></launch>\n',
    "in.launch.yaml": "launch:\n- node: {pkg: demo, exec: eye, name: eye}\n",
    "in.launch.py": (
        "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n"
        "def generate_launch_description():\n    return LaunchDescription([\n"
        "        Node(package='demo', executable='eye', name='eye')])\n"
    ),
}


def _shown(folder: Path, text: str, name: str = "main.launch.xml") -> tuple[list[str], list[str]]:
    """Return the names of the nodes that a launch file starts, and what is said of it."""
    file = folder / "demo/launch" / name
    file.write_text(text)
    found = launch_graph(file, {}, find_boundary(file.parent))
    assert found.workspace is not None
    names = [each.name for each in found.workspace.nodes.values()]
    return names, [each.message for each in found.diagnostics]


@pytest.fixture
def project(tmp_path: Path) -> Path:
    folder = tmp_path / "project"
    (folder / ".git").mkdir(parents=True)
    (folder / "demo/launch").mkdir(parents=True)
    (folder / "demo/package.xml").write_text("<package><name>demo</name></package>")
    for name, text in INCLUDED.items():
        (folder / "demo/launch" / name).write_text(text)
    return folder


@pytest.mark.parametrize("name", INCLUDED)
@pytest.mark.parametrize("where", ["$(dirname)", "$(find-pkg-share demo)/launch"])
def test_what_is_included_is_shown(project: Path, name: str, where: str) -> None:
    text = (
        '<launch><group><push_ros_namespace namespace="front"/>'
        f'<include file="{where}/{name}"/></group></launch>\n'
    )
    names, said = _shown(project, text)
    assert names == ["/front/eye"]
    assert all("left out" not in each for each in said)


def test_ros1_files_are_followed_too(project: Path) -> None:
    inner = '<launch><node pkg="demo" type="eye" name="eye"/></launch>\n'
    (project / "demo/launch/in.launch").write_text(inner)
    text = '<launch><include file="$(find demo)/launch/in.launch" ns="front"/></launch>\n'
    assert _shown(project, text, "main.launch")[0] == ["/front/eye"]


def test_a_file_in_yaml_is_shown(project: Path) -> None:
    names, _ = _shown(project, INCLUDED["in.launch.yaml"], "main.launch.yaml")
    assert names == ["eye"]


@pytest.mark.parametrize(
    "file, reason",
    [
        ("$(find-pkg-share other)/x.launch.xml", "$(find-pkg-share other)"),
        ("in.launch.xml", "a whole one"),
        ("$(dirname)/none.launch.xml", "No such file"),
        ("$(dirname)/../../../out.launch.xml", "outside"),
        ("$(dirname)/main.launch.xml", "`main.launch.xml` includes itself without end"),
    ],
)
def test_what_cannot_be_followed_is_listed(project: Path, file: str, reason: str) -> None:
    (project.parent / "out.launch.xml").write_text(INCLUDED["in.launch.xml"])
    names, said = _shown(project, f'<launch><include file="{file}"/></launch>\n')
    assert names == []
    assert any(reason.lower() in each.lower() for each in said), said


ENDLESS = "`main.launch.xml` includes itself without end"


@pytest.mark.parametrize(
    ("name", "main", "other", "said"),
    [
        ("main.launch.xml", '<include file="$(dirname)/main.launch.xml"/>', "", ENDLESS),
        (
            "main.launch.xml",
            '<include file="$(dirname)/b.launch.xml"/>',
            '<arg name="own" default="1"/><include file="$(dirname)/main.launch.xml"/>',
            f"{ENDLESS}, by `b.launch.xml`",
        ),
        (
            "main.launch",
            '<arg name="n" default="1"/><include file="$(dirname)/b.launch.xml"/>',
            '<include file="$(dirname)/main.launch"/>',
            "`main.launch` includes itself without end, by `b.launch.xml`",
        ),
        (
            # The argument ends it.
            "main.launch",
            '<arg name="more" default="true"/><include if="$(arg more)" '
            'file="$(dirname)/main.launch"><arg name="more" value="false"/></include>',
            "",
            None,
        ),
        (
            "main.launch.xml",
            '<arg name="more" default="true"/><include if="$(var more)" '
            'file="$(dirname)/main.launch.xml"><arg name="more" value="false"/></include>',
            "",
            None,
        ),
    ],
)
def test_files_that_include_each_other_without_end_are_wrong(
    project: Path, name: str, main: str, other: str, said: str | None
) -> None:
    file = project / "demo/launch" / name
    key = "type" if name == "main.launch" else "exec"
    node = f'<node pkg="demo" {key}="eye" name="eye"/>'
    file.write_text(f"<launch>{node}{main}</launch>\n")
    (file.parent / "b.launch.xml").write_text(f"<launch>{other}</launch>\n")
    found = launch_graph(file, {}, find_boundary(file.parent))
    wrong = [each for each in found.diagnostics if each.severity is Severity.ERROR]
    assert [each.message for each in wrong] == ([] if said is None else [said])
    assert all(each.span is not None and each.file is not None for each in wrong)
    assert found.workspace is not None
    assert len(found.workspace.nodes) == (1 if said else 2)


@pytest.mark.parametrize("output", ["output", "build", "install"])
@pytest.mark.parametrize(
    ("name", "find", "package"),
    [
        ("main.launch.xml", "find-pkg-share", "demo"),
        ("main.launch.xml", "find-pkg-share", "beside"),
        ("main.launch", "find", "demo"),
        ("main.launch", "find", "beside"),
    ],
)
def test_packages_of_an_output_folder_are_known(
    tmp_path: Path, output: str, name: str, find: str, package: str
) -> None:
    (tmp_path / ".git").mkdir()
    word = "exec" if find == "find-pkg-share" else "type"
    for place, node in (("a_copy", "other"), (output, "eye")):
        for each in ("demo", "beside"):
            folder = tmp_path / place / each / "launch"
            folder.mkdir(parents=True)
            (folder.parent / "package.xml").write_text(f"<package><name>{each}</name></package>")
            text = f'<launch><node pkg="demo" {word}="{node}" name="{node}"/></launch>\n'
            (folder / "in.launch").write_text(text)
            (folder / "in.launch.xml").write_text(text)
    inner = name.replace("main", "in")
    text = f'<launch><include file="$({find} {package})/launch/{inner}"/></launch>\n'
    names, said = _shown(tmp_path / output, text, name)
    assert names == ["eye"]
    assert not [each for each in said if "left out" in each]


@pytest.mark.parametrize("marker", ["COLCON_IGNORE", "CATKIN_IGNORE", "AMENT_IGNORE", ""])
def test_the_graph_and_a_run_take_the_same_package(project: Path, marker: str) -> None:
    for place, name in (("a_old/eyes", "eyes"), ("z_new/eyes", "eyes"), ("z_new/ears", "ears")):
        (project / place / "scripts").mkdir(parents=True)
        (project / place / "package.xml").write_text(f"<package><name>{name}</name></package>")
        (project / place / "scripts/eye.py").write_text("#!/usr/bin/env python3\n")
    if marker:
        (project / "a_old" / marker).touch()
    file = project / "demo/launch/main.launch.xml"
    file.write_text('<launch><include file="$(find-pkg-share eyes)/a.launch.xml"/></launch>')
    environment = Environment(Origin.EXTRA, 2, "kilted", Path("/opt/none/bin/python3"))
    run = find_packages(file, environment, {}).share("eyes")
    assert run == str(project / ("z_new/eyes" if marker else "a_old/eyes"))
    _, (said,) = _shown(project, file.read_text())
    assert said.startswith(f"`{run}/a.launch.xml`")


def test_all_nodes_of_a_name_are_shown(project: Path) -> None:
    node = '<node pkg="demo" exec="eye" name="eye"/>'
    assert _shown(project, f"<launch>{3 * node}</launch>")[0] == ["eye", "eye", "eye"]
