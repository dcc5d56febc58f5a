"""The packages of the examples of the packages' rules."""

from __future__ import annotations

from .graph_examples import SETUP_CFG, TALKER


def package_xml(
    name: str,
    *more: str,
    build_type: str = "ament_python",
    exec_depend: list[str] | None = None,
    format_: int = 3,
) -> str:
    """Return a package.xml, with lines that it has besides."""
    lines = [*(f"<exec_depend>{each}</exec_depend>" for each in exec_depend or ()), *more]
    inner = "\n".join(f"  {line}" for line in lines)
    return f"""\
<?xml version="1.0"?>
<package format="{format_}">
  <name>{name}</name>
  <version>0.1.0</version>
  <description>An example.</description>
  <maintainer email="ada@example.com">Ada</maintainer>
  <license>MIT</license>
{inner}
  <export>
    <build_type>{build_type}</build_type>
  </export>
</package>
"""


def setup_py(*scripts: str, name: str = "demo") -> str:
    """Return a setup.py with console scripts."""
    listed = ", ".join(f"'{each}'" for each in scripts)
    return f"""\
from setuptools import setup

setup(
    name='{name}',
    version='0.1.0',
    packages=['{name}'],
    data_files=[('share/{name}', ['package.xml'])],
    entry_points={{'console_scripts': [{listed}]}},
)
"""


NODE_PACKAGE = {
    "demo/package.xml": package_xml("demo", exec_depend=["rclpy", "std_msgs"]),
    "demo/setup.py": setup_py("talker = demo.talker:main"),
    "demo/setup.cfg": SETUP_CFG,
    "demo/demo/__init__.py": "",
    "demo/demo/talker.py": TALKER,
}
"""A package with one node, with nothing wrong."""


def cmake_lists(*lines: str, find: str = "") -> str:
    """Return a CMakeLists.txt of ROS 2."""
    inner = "\n".join(lines)
    return f"""\
cmake_minimum_required(VERSION 3.8)
project(demo)
find_package(ament_cmake REQUIRED)
{find}{inner}
ament_package()
"""


SCRIPT_PACKAGE = {
    "demo/package.xml": package_xml(
        "demo",
        "<buildtool_depend>ament_cmake</buildtool_depend>",
        build_type="ament_cmake",
        exec_depend=["rclpy", "std_msgs"],
    ),
    "demo/CMakeLists.txt": cmake_lists(
        "install(PROGRAMS scripts/talker.py DESTINATION lib/${PROJECT_NAME})"
    ),
    "demo/scripts/talker.py": f"#!/usr/bin/env python3\n{TALKER}\n\nif __name__ == '__main__':\n"
    "    main()\n",
}
"""A package of CMake with one node in Python, with nothing wrong."""

TYPES_PACKAGE = {
    "demo/package.xml": package_xml(
        "demo",
        "<buildtool_depend>ament_cmake</buildtool_depend>",
        "<buildtool_depend>rosidl_default_generators</buildtool_depend>",
        "<exec_depend>rosidl_default_runtime</exec_depend>",
        "<member_of_group>rosidl_interface_packages</member_of_group>",
        build_type="ament_cmake",
    ),
    "demo/CMakeLists.txt": cmake_lists(
        'rosidl_generate_interfaces(${PROJECT_NAME} "msg/Speed.msg")',
        find="find_package(rosidl_default_generators REQUIRED)\n",
    ),
    "demo/msg/Speed.msg": "float64 value\n",
}
"""A package of types, with nothing wrong."""

SPEED_USER = """\
import rclpy
from demo.msg import Speed
from rclpy.node import Node


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.pub = self.create_publisher(Speed, 'speed', 10)
        self.timer = self.create_timer(1.0, self.send)

    def send(self):
        self.pub.publish(Speed(value=1.0))


def main():
    rclpy.init()
    rclpy.spin(Driver())
"""
"""A node that uses the field of that type."""
