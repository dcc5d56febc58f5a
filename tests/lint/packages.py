"""Packages that the tests of the packages' rules break."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from linted import write_tree

from plastron_tui.lint import lint
from plastron_tui.lint.engine import Found
from plastron_tui.lint.rules import RULES
from plastron_tui.lint.rules.package_examples import package_xml, setup_py
from plastron_tui.project.linting import read_tree
from plastron_tui.project.linting.cache import FactCache

PY_NODE = """\
#!/usr/bin/env python3
import rclpy
from rclpy.node import Node
from geometry_msgs.msg import Twist


class Mover(Node):
    def __init__(self):
        super().__init__('mover')
        self.pub = self.create_publisher(Twist, 'cmd_vel', 10)


def main():
    rclpy.init()
    rclpy.spin(Mover())


if __name__ == '__main__':
    main()
"""

CPP_NODE = """\
#include <rclcpp/rclcpp.hpp>
#include "geometry_msgs/msg/twist.hpp"

class Mover : public rclcpp::Node
{
public:
  Mover() : Node("mover")
  {
    pub_ = create_publisher<geometry_msgs::msg::Twist>("cmd_vel", 10);
  }

private:
  rclcpp::Publisher<geometry_msgs::msg::Twist>::SharedPtr pub_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Mover>());
}
"""

ROS1_NODE = """\
#!/usr/bin/env python
import rospy
from geometry_msgs.msg import Twist

if __name__ == '__main__':
    rospy.init_node('mover')
    pub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
    rospy.spin()
"""

CPP_LISTS = """\
cmake_minimum_required(VERSION 3.8)
project(rover)
find_package(ament_cmake REQUIRED)
find_package(rclcpp REQUIRED)
find_package(geometry_msgs REQUIRED)
find_package(rosidl_default_generators REQUIRED)
rosidl_generate_interfaces(${PROJECT_NAME}
  "msg/Speed.msg"
  "srv/Reset.srv"
  DEPENDENCIES geometry_msgs
)
add_executable(mover src/mover.cpp)
ament_target_dependencies(mover rclcpp geometry_msgs)
install(TARGETS mover DESTINATION lib/${PROJECT_NAME})
add_library(part SHARED src/part.cpp)
rclcpp_components_register_nodes(part "rover::Mover")
install(PROGRAMS
  scripts/mover.py
  DESTINATION lib/${PROJECT_NAME})
install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})
ament_package()
"""

CATKIN_LISTS = """\
cmake_minimum_required(VERSION 3.0.2)
project(old)
find_package(catkin REQUIRED COMPONENTS rospy geometry_msgs message_generation)
add_message_files(
  FILES
  Speed.msg
)
generate_messages(DEPENDENCIES geometry_msgs)
catkin_package(CATKIN_DEPENDS message_runtime)
catkin_install_python(PROGRAMS scripts/mover.py
  DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION}
)
"""

_AMENT = (
    "<buildtool_depend>ament_cmake</buildtool_depend>",
    "<buildtool_depend>rosidl_default_generators</buildtool_depend>",
    "<depend>rclcpp</depend>",
    "<depend>rclpy</depend>",
    "<depend>geometry_msgs</depend>",
    "<exec_depend>rosidl_default_runtime</exec_depend>",
    "<member_of_group>rosidl_interface_packages</member_of_group>",
)
_CATKIN = (
    "<buildtool_depend>catkin</buildtool_depend>",
    "<build_depend>message_generation</build_depend>",
    "<depend>rospy</depend>",
    "<depend>geometry_msgs</depend>",
    "<exec_depend>message_runtime</exec_depend>",
)

PYTHON = {
    "wheels/package.xml": package_xml("wheels", exec_depend=["rclpy", "geometry_msgs"]),
    "wheels/setup.py": setup_py("mover = wheels.mover:main", name="wheels"),
    "wheels/setup.cfg": "[develop]\nscript_dir=$base/lib/wheels\n"
    "[install]\ninstall_scripts=$base/lib/wheels\n",
    "wheels/wheels/__init__.py": "",
    "wheels/wheels/mover.py": PY_NODE,
    "wheels/launch/wheels.launch.py": """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='wheels', executable='mover'),
    ])
""",
}
CMAKE = {
    "rover/package.xml": package_xml("rover", *_AMENT, build_type="ament_cmake"),
    "rover/CMakeLists.txt": CPP_LISTS,
    "rover/src/mover.cpp": CPP_NODE,
    "rover/scripts/mover.py": PY_NODE,
    "rover/msg/Speed.msg": "geometry_msgs/Twist twist\n",
    "rover/srv/Reset.srv": "---\nbool done\n",
    "rover/launch/rover.launch.xml": '<launch>\n  <node pkg="rover" exec="mover"/>\n'
    '  <node pkg="rover" exec="mover.py"/>\n</launch>\n',
}
CATKIN = {
    "old/package.xml": package_xml("old", *_CATKIN, build_type="catkin", format_=2).replace(
        "  <export>\n    <build_type>catkin</build_type>\n  </export>\n", ""
    ),
    "old/CMakeLists.txt": CATKIN_LISTS,
    "old/scripts/mover.py": ROS1_NODE,
    "old/msg/Speed.msg": "geometry_msgs/Twist twist\n",
    "old/launch/old.launch": '<launch>\n  <node pkg="old" type="mover.py" name="mover"/>\n'
    "</launch>\n",
}
WORKSPACE = PYTHON | CMAKE | CATKIN
_PROGRAMS = ("rover/scripts/mover.py", "old/scripts/mover.py")


@dataclass(frozen=True)
class Break:
    """A change of the workspace, and what it breaks.

    Attributes:
        file: the file that is changed.
        old: the text that is replaced; "" for all of it.
        new: the text in its place, None where the file is taken away.
        found: the rules that tell it, with file and line; "" for nothing.
        more: further files that are there, or are so.
    """

    file: str
    old: str
    new: str | None
    found: str = ""
    more: Mapping[str, str] = field(default_factory=dict)

    def files(self, workspace: Mapping[str, str]) -> dict[str, str]:
        """Return the workspace with the change."""
        files = {**workspace, **self.more}
        text = files.get(self.file, "")
        assert self.old in text
        if self.new is None:
            del files[self.file]
        else:
            files[self.file] = text.replace(self.old, self.new, 1) if self.old else self.new
        return files


def found_in(
    folder: Path, files: Mapping[str, str], programs: tuple[str, ...] = _PROGRAMS
) -> list[Found]:
    """Return what the packages' rules tell of files."""
    root = write_tree(folder, files)
    for name in programs:
        if name in files:
            (root / name).chmod(0o755)
    tree = read_tree([root], FactCache(root, folder / "cache"), workers=1)
    return list(lint(tree, [rule for code, rule in RULES.items() if code.startswith("RK")]))


def told_of(folder: Path, files: Mapping[str, str], programs: tuple[str, ...] = _PROGRAMS) -> str:
    """Return what the packages' rules tell of files: code, file and line of each."""
    found = []
    for each in found_in(folder, files, programs):
        file, span = each.diagnostic.file, each.diagnostic.span
        assert file is not None and span is not None
        line = file.read_bytes()[: span.start].count(b"\n") + 1
        found.append(f"{each.rule.code} {file.relative_to(folder / 'src')}:{line}")
    return ", ".join(found)
