"""Packages to load, one of each build type, and programs that change them."""

from __future__ import annotations

from pathlib import Path

from plastron_tui.diagnostics import Diagnostic, has_errors
from plastron_tui.output.writer import write
from plastron_tui.session import Options, Session

TALKER = """\
create_node 'talker' as talker
create_message greeting of message_type String and input "hello"
talker publish greeting to 'chatter' of message_type String at 2 hz
load_package 'demo' as demo
"""
IN = f"{TALKER}demo contains talker\ngenerate_package demo\n"
OUT = "load_package 'demo' as demo\ndemo no_longer_contains 'talker'\ngenerate_package demo\n"

AMENT_PYTHON = {
    "package.xml": """\
<?xml version="1.0"?>
<package format="3">
  <name>demo</name>
  <version>0.1.0</version>
  <description>Says hello.</description>
  <maintainer email="ada@example.com">Ada</maintainer>
  <license>MIT</license>

  <!-- what runs -->
  <exec_depend>rclpy</exec_depend>  <!-- the client library -->

  <export>
    <build_type>ament_python</build_type>
  </export>
</package>
""",
    "setup.py": """\
from setuptools import setup

package_name = 'demo'

setup(
    name=package_name,
    version='0.1.0',
    packages=[package_name],
    data_files=[('share/' + package_name, ['package.xml'])],
    entry_points={
        'console_scripts': [
            'listener = demo.listener:main',  # hears it
        ],
    },
)
""",
    "setup.cfg": "[install]\ninstall_scripts=$base/lib/demo\n",
    "demo/__init__.py": "",
    "demo/listener.py": "import rclpy\n\n\ndef main():\n    rclpy.init()\n",
}

AMENT_CMAKE = {
    "package.xml": AMENT_PYTHON["package.xml"].replace("ament_python", "ament_cmake"),
    "CMakeLists.txt": """\
cmake_minimum_required(VERSION 3.8)
project(demo)

find_package(ament_cmake REQUIRED)
find_package(ament_cmake_python REQUIRED)

ament_python_install_package(${PROJECT_NAME})

# Nodes
install(PROGRAMS
  nodes/listener.py
  DESTINATION lib/${PROJECT_NAME}
)

ament_package()
""",
    "demo/__init__.py": "",
    "nodes/listener.py": "#!/usr/bin/env python3\nimport rclpy\n",
}

CATKIN = {
    "package.xml": """\
<package format="2">
  <name>demo</name>
  <version>0.1.0</version>
  <description>Says hello.</description>
  <maintainer email="ada@example.com">Ada</maintainer>
  <license>MIT</license>
  <buildtool_depend>catkin</buildtool_depend>
  <exec_depend>rospy</exec_depend>
</package>
""",
    "CMakeLists.txt": """\
cmake_minimum_required(VERSION 3.0.2)
project(demo)
find_package(catkin REQUIRED)
catkin_package()
catkin_install_python(PROGRAMS scripts/listener.py
  DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
""",
    "scripts/listener.py": "#!/usr/bin/env python3\nimport rospy\n",
}

KINDS = {
    "ament_python": ("rclpy", AMENT_PYTHON),
    "ament_cmake": ("rclpy", AMENT_CMAKE),
    "catkin": ("rospy", CATKIN),
}


def lay(folder: Path, files: dict[str, str] | dict[str, bytes], name: str = "demo") -> Path:
    """Write the files of a package."""
    for path, text in files.items():
        target = folder / name / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(text.encode() if isinstance(text, str) else text)
    return folder / name


def texts(folder: Path) -> dict[str, bytes]:
    """Return what the files of a folder hold, by their paths."""
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file() and path.name != ".plastron.json"
    }


def run(
    program: str, folder: Path, library: str, *, in_place: bool = False
) -> tuple[Diagnostic, ...]:
    """Write what a program asks for, unless something is refused; return what it is told."""
    options = Options(library, folder / "output", in_place)
    session = Session(program.encode(), folder / "a.plastron", options, environ={})
    plan, found = session.plan()
    told = tuple(dict.fromkeys((*session.diagnostics, *found, *plan.conflicts)))
    if not has_errors(told):
        told += write(plan).diagnostics
    return told
