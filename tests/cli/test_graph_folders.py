"""`plastron graph` of a workspace that nobody generated."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from command_line import Run, write

NODE = """\
import rospy
from std_msgs.msg import String
rospy.init_node('{name}')
x = rospy.{what}('chatter', String, {more})
rospy.spin()
"""
LAUNCH = """\
<launch>
  <node pkg="p" type="talker.py" name="one" ns="a"/>
  <node pkg="p" type="talker.py" name="two"><remap from="chatter" to="/b"/></node>
</launch>
"""
PACKAGE = """\
<package format="2"><name>p</name><version>1.0.0</version><description>d</description>
<maintainer email="a@b.org">a</maintainer><license>MIT</license>
<buildtool_depend>catkin</buildtool_depend></package>
"""
CMAKE = "project(p)\nfind_package(catkin REQUIRED)\ncatkin_package()\n"
CMAKE += "catkin_install_python(PROGRAMS scripts/talker.py DESTINATION bin)\n"


@pytest.fixture
def workspace(here: Path) -> Path:
    files = {
        "package.xml": PACKAGE,
        "CMakeLists.txt": CMAKE,
        "scripts/talker.py": NODE.format(name="t", what="Publisher", more="queue_size=1"),
        "scripts/listener.py": NODE.format(name="l", what="Subscriber", more="print"),
        "launch/a.launch": LAUNCH,
    }
    for name, text in files.items():
        file = here / "src" / "p" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
        file.chmod(0o755)
    return here


def test_the_nodes_have_the_names_that_launch_files_give(workspace: Path, run: Run) -> None:
    result = run("graph", "--format", "json", "src")
    assert (result.returncode, result.stderr) == (0, b"")
    graph = json.loads(result.stdout)
    assert sorted(node["name"] for node in graph["nodes"]) == ["/a/one", "l", "two"]
    assert sorted(topic["name"] for topic in graph["topics"]) == ["/a/chatter", "/b", "/chatter"]


OTHER = '<launch><node pkg="p" type="talker.py" name="three"/></launch>'
PICKED = {
    "by_name": ("a.launch", ["/a/one", "two"]),
    "by_path": ("p/launch/b.launch", ["three"]),
    "by_a_part_of_a_name": (".launch", None),
    "of_nobody": ("c.launch", None),
    "of_two": ("d.launch", None),
}


@pytest.mark.parametrize(("name", "nodes"), PICKED.values(), ids=PICKED)
def test_nodes_of_one_launch_file_are_shown_alone(
    workspace: Path, run: Run, name: str, nodes: list[str] | None
) -> None:
    for other in ("launch/b.launch", "launch/d.launch", "more/d.launch"):
        file = workspace / "src" / "p" / other
        file.parent.mkdir(exist_ok=True)
        file.write_text(OTHER)
    result = run("graph", "--format", "json", "--launch", name, "src")
    assert (result.returncode == 2) is (nodes is None)
    if nodes is None:
        assert name.encode() in result.stderr
        assert b"d.launch" in result.stderr
    else:
        shown = json.loads(result.stdout)
        assert sorted(node["name"] for node in shown["nodes"]) == nodes


def test_programs_of_the_workspace_are_there(workspace: Path, run: Run) -> None:
    program = "create_node 'n' as n using rospy\nsubscribe n to 'x' of message_type String\n"
    write(workspace / "src", program)
    assert b"n  " in run("graph", "src").stdout


@pytest.mark.parametrize(
    "arguments",
    [
        ("src", "a.plastron"),
        ("src", "--remap", "a:=b"),
        ("src", "--namespace", "/a"),
        ("a.plastron", "--launch", "a.launch"),
    ],
)
def test_a_folder_is_shown_alone(workspace: Path, run: Run, arguments: tuple[str, ...]) -> None:
    write(workspace, "create_node 'n' as n\n")
    assert run("graph", *arguments).returncode == 2
