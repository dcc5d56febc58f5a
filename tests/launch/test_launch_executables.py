"""Executables that a launch file names, found as the build files of their packages make them."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.boundary import find_boundary
from plastron_tui.project.launch_graph import launch_graph
from plastron_tui.ros.installations import Origin
from plastron_tui.runtime.environment import Environment
from plastron_tui.runtime.launch_packages import find_packages

PYTHON = Path("/python")
ENVIRONMENT = Environment(Origin.EXTRA, 2, "kilted", PYTHON)
NODE = """\
#!/usr/bin/env python3
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.pub = self.create_publisher(String, 'chatter', 10)


def main():
    rclpy.init()
    rclpy.spin(Talker())
"""
XML = """\
<package format="3">
  <name>demo</name>
  <version>0.1.0</version>
  <description>d</description>
  <maintainer email="a@b.org">A</maintainer>
  <license>MIT</license>
  <export><build_type>{}</build_type></export>
</package>
"""
SETUP = "from setuptools import setup\nsetup(name='demo', packages=['demo']{})\n"
POINTS = ", entry_points={'console_scripts': ['talker = demo.talk:main']}"
CMAKE = """\
project(demo)
find_package(ament_cmake REQUIRED)
{}
ament_package()
"""
PACKAGES: dict[str, tuple[str, dict[str, str], str]] = {
    "setup.cfg": (
        "ament_python",
        {
            "setup.py": SETUP.format(""),
            "setup.cfg": "[options.entry_points]\nconsole_scripts =\n    talker = demo.talk:main\n",
            "demo/__init__.py": "",
            "demo/talk.py": NODE,
        },
        "",
    ),
    "package_dir": (
        "ament_python",
        {
            "setup.py": SETUP.format(f"{POINTS}, package_dir={{'': 'src'}}"),
            "src/demo/__init__.py": "",
            "src/demo/talk.py": NODE,
        },
        "src",
    ),
    "renamed": (
        "ament_cmake",
        {
            "CMakeLists.txt": CMAKE.format(
                "install(PROGRAMS nodes/talk.py DESTINATION lib/demo RENAME talker)"
            ),
            "nodes/talk.py": NODE,
        },
        "",
    ),
    "not followed": (
        "ament_python",
        {
            "setup.py": SETUP.format(POINTS),
            "pyproject.toml": "[project]\n",
            "demo/__init__.py": "",
            "demo/talk.py": NODE,
        },
        "",
    ),
}


@pytest.mark.parametrize("kind", PACKAGES)
def test_run_and_graph_find_what_a_package_installs(kind: str, tmp_path: Path) -> None:
    build_type, files, root = PACKAGES[kind]
    package = tmp_path / "demo"
    launch = package / "launch/a.launch.xml"
    for name, text in {"package.xml": XML.format(build_type), **files}.items():
        path = package / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    launch.parent.mkdir()
    launch.write_text('<launch><node pkg="demo" exec="talker"/></launch>\n')
    packages = find_packages(launch, ENVIRONMENT, {})
    found = packages.executable("demo", "talker", PYTHON)
    assert found is not None
    if build_type == "ament_python":
        assert found.command[-1] == "demo.talk:main"
    else:
        assert found.command == (str(PYTHON), str(package / "nodes/talk.py"))
    assert found.folders[0] == ("PYTHONPATH", package / root)
    assert "talker" in packages.names("demo", PYTHON)
    graph = launch_graph(launch, {}, find_boundary(tmp_path))
    assert graph.diagnostics == ()
    assert graph.workspace is not None
    (node,) = graph.workspace.nodes.values()
    assert node.source is not None
    assert [each.label for each in node.source.endpoints] == ["chatter"]
