"""The nodes and the parameter files of the examples of the rules on parameters."""

from __future__ import annotations

from .graph_examples import SETUP_CFG

_LAUNCH = """\
<launch>
  <node pkg="rover" exec="driver" name="driver">
    <param from="$(find-pkg-share rover)/config/driver.yaml"/>
  </node>
</launch>
"""

_PACKAGE = """\
<package format="3">
  <name>rover</name>
  <version>0.1.0</version>
  <description>A rover.</description>
  <maintainer email="ada@example.com">Ada</maintainer>
  <license>Apache-2.0</license>
  <exec_depend>rclpy</exec_depend>
  <export><build_type>ament_python</build_type></export>
</package>
"""

_SETUP = """\
from setuptools import setup

setup(
    name='rover',
    packages=['rover'],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/rover']),
        ('share/rover', ['package.xml']),
        ('share/rover/config', ['config/driver.yaml']),
        ('share/rover/launch', ['launch/rover.launch.xml']),
    ],
    entry_points={'console_scripts': ['driver = rover.driver:main']},
)
"""


def node(*, used: str = "max_speed") -> str:
    """Return a node that declares `max_speed` and uses a parameter."""
    return f"""\
import rclpy
from rclpy.node import Node


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.declare_parameter('max_speed', 0.5)
        self.speed = self.get_parameter('{used}').value


def main():
    rclpy.init()
    rclpy.spin(Driver())
"""


def given(value: str, *, block: str = "driver") -> dict[str, str]:
    """Return a package whose launch file gives its node a file with a value."""
    return {
        "rover/package.xml": _PACKAGE,
        "rover/setup.py": _SETUP,
        "rover/setup.cfg": SETUP_CFG.replace("demo", "rover"),
        "rover/resource/rover": "",
        "rover/rover/__init__.py": "",
        "rover/rover/driver.py": node(),
        "rover/launch/rover.launch.xml": _LAUNCH,
        "rover/config/driver.yaml": f"{block}:\n  ros__parameters:\n    {value}\n",
    }


GIVEN = given("max_speed: 1.0")
UNDECLARED = {"driver.py": node(used="max_sped")}
