"""Packages with nodes, launch files and parameter files, and what lint says of them."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from textwrap import dedent, indent

from linted import write_tree

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.lint.rules import RULES
from plastron_tui.lint.rules.parameters_examples import GIVEN
from plastron_tui.lint.tree import SourceTree
from plastron_tui.project.linting import read_tree
from plastron_tui.project.linting.cache import FactCache

NODE = "rover/rover/driver.py"
LAUNCH = "rover/launch/rover.launch.py"
CONFIG = "rover/config/driver.yaml"

_PYTHON = """\
import rclpy
from rcl_interfaces.msg import ParameterDescriptor
from rclpy.node import Node
from rclpy.parameter import Parameter


class Driver(Node):
    def __init__(self):
        super().__init__('driver'{handed})
{made}


def main():
    rclpy.init()
    rclpy.spin(Driver())
"""


def python(made: str, *, handed: str = "") -> str:
    """Return a node in Python whose constructor has some lines."""
    body = indent(dedent(made).strip("\n"), " " * 8)
    return _PYTHON.format(handed=handed, made=body)


def cpp(made: str, *, base: str = "rclcpp::Node", more: str = "") -> str:
    """Return a node in C++ whose constructor has some lines."""
    return f"""\
#include <rclcpp/rclcpp.hpp>
#include <tf2_ros/transform_listener.h>

class Driver : public {base}
{{
public:
  Driver() : {base}("driver")
  {{
{indent(dedent(made).strip(chr(10)), " " * 4)}
  }}
{more}
}};

int main(int argc, char ** argv)
{{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Driver>());
}}
"""


def launch(*nodes: str) -> str:
    """Return a launch file in Python; `CONFIG` in a node is the package's parameter file."""
    started = "".join(f"        {node},\n" for node in nodes)
    return f"""\
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    CONFIG = os.path.join(get_package_share_directory('rover'), 'config', 'driver.yaml')
    return LaunchDescription([
{started}    ])
"""


def driver(parameters: str, others: str = "") -> str:
    """Return the node of the package in a launch file."""
    start = "Node(package='rover', executable='driver', name='driver'"
    return f"{start}, parameters=[{parameters}]{others})"


def package(files: Mapping[str, str]) -> dict[str, str]:
    """Return a package of one node, with other files, or more."""
    kept = {name: text for name, text in GIVEN.items() if not name.endswith(".launch.xml")}
    return {**kept, LAUNCH: launch(driver("CONFIG")), **files}


def read(folder: Path, files: Mapping[str, str]) -> SourceTree:
    """Return what is read of a workspace."""
    root = write_tree(folder, files)
    return read_tree([root], FactCache(root, folder / "cache"), workers=1)


def found(folder: Path, files: Mapping[str, str], *codes: str) -> list[Diagnostic]:
    """Return what rules find in a workspace, in the order of files and places."""
    tree = read(folder, files)
    told = [each for code in codes for each in RULES[code].check(tree)]
    return sorted(told, key=lambda each: (str(each.file), each.span or (0, 0)))


def told(folder: Path, files: Mapping[str, str], *codes: str) -> list[str]:
    """Return the lines that rules tell of."""
    lines = []
    for each in found(folder, files, *codes):
        assert each.file is not None
        assert each.span is not None
        text = each.file.read_text()
        lines.append(text.splitlines()[text.encode()[: each.span.start].count(b"\n")].strip())
    return lines


def marked(files: Mapping[str, str]) -> list[str]:
    """Return the lines that end in the mark of a mistake."""
    return [
        line.strip()
        for name in sorted(files)
        for line in files[name].splitlines()
        if line.rstrip().endswith(("# wrong", "// wrong"))
    ]
