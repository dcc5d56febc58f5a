"""The graph of launch files that include others, in XML, YAML and Python."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.boundary import find_boundary
from plastron_tui.project.launch_graph import launch_graph

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
        ("$(dirname)/main.launch.xml", "too often"),
    ],
)
def test_what_cannot_be_followed_is_listed(project: Path, file: str, reason: str) -> None:
    (project.parent / "out.launch.xml").write_text(INCLUDED["in.launch.xml"])
    names, said = _shown(project, f'<launch><include file="{file}"/></launch>\n')
    assert names == []
    assert any(reason.lower() in each.lower() for each in said), said
