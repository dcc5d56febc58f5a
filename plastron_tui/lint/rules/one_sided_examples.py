"""The workspaces of the examples of what one side alone uses: their types are their own."""

from __future__ import annotations

_PACKAGE = """\
<package format="3">
  <name>demo_msgs</name>
  <version>0.1.0</version>
  <description>The types of both nodes</description>
  <maintainer email="someone@example.org">Someone</maintainer>
  <license>MIT</license>
  <buildtool_depend>ament_cmake</buildtool_depend>
  <build_depend>rosidl_default_generators</build_depend>
  <exec_depend>rosidl_default_runtime</exec_depend>
  <member_of_group>rosidl_interface_packages</member_of_group>
  <export><build_type>ament_cmake</build_type></export>
</package>
"""
_CMAKE = """\
cmake_minimum_required(VERSION 3.8)
project(demo_msgs)
find_package(ament_cmake REQUIRED)
find_package(rosidl_default_generators REQUIRED)
rosidl_generate_interfaces(${{PROJECT_NAME}} "{file}")
ament_package()
"""
_NODE = """\
import rclpy
from demo_msgs.{module} import {type}
from rclpy.node import Node


class {name}(Node):
    def __init__(self):
        super().__init__('{lower}')
        {make}

{callback}
def main():
    rclpy.init()
    rclpy.spin({name}())
"""


def _node(name: str, make: str, callback: str = "", *, module: str = "msg") -> str:
    type_ = "Level" if module == "msg" else "Refill"
    return _NODE.format(
        module=module, type=type_, name=name, lower=name.lower(), make=make, callback=callback
    )


def _topic(published: str, heard: str) -> dict[str, str]:
    hears = f"self.sub = self.create_subscription(Level, '{heard}', self.on_level, 10)"
    on_level = "    def on_level(self, msg):\n        self.get_logger().info(str(msg.liters))\n\n"
    return {
        "demo_msgs/package.xml": _PACKAGE,
        "demo_msgs/CMakeLists.txt": _CMAKE.format(file="msg/Level.msg"),
        "demo_msgs/msg/Level.msg": "float32 liters\n",
        "tank.py": _node("Tank", f"self.pub = self.create_publisher(Level, '{published}', 10)"),
        "display.py": _node("Display", hears, on_level),
    }


def _service(provided: str, called: str) -> dict[str, str]:
    provides = f"self.srv = self.create_service(Refill, '{provided}', self.on_refill)"
    on_refill = "    def on_refill(self, request, response):\n        return response\n\n"
    calls = f"self.refill = self.create_client(Refill, '{called}')"
    return {
        "demo_msgs/package.xml": _PACKAGE,
        "demo_msgs/CMakeLists.txt": _CMAKE.format(file="srv/Refill.srv"),
        "demo_msgs/srv/Refill.srv": "float32 liters\n---\nbool done\n",
        "tank.py": _node("Tank", provides, on_refill, module="srv"),
        "display.py": _node("Display", calls, module="srv"),
    }


_TOPICS = {"bad": _topic("level", "tank_state"), "good": _topic("level", "level")}
_SERVICES = {"bad": _service("refill", "fill_tank"), "good": _service("refill", "refill")}
PUBLISHED = HEARD = _TOPICS
PROVIDED = CALLED = _SERVICES
