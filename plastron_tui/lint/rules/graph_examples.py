"""The nodes of the examples of the graph's rules."""

from __future__ import annotations


def talker(*, type: str = "String", topic: str = "chatter", qos: str = "10") -> str:  # noqa: A002
    """Return a node that publishes."""
    imported = f"from rclpy.qos import {qos}\n" if qos.startswith("qos") else ""
    return f"""\
import rclpy
from rclpy.node import Node
{imported}from std_msgs.msg import {type}


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.pub = self.create_publisher({type}, '{topic}', {qos})


def main():
    rclpy.init()
    rclpy.spin(Talker())
"""


def listener(*, type: str = "String", topic: str = "chatter") -> str:  # noqa: A002
    """Return a node that subscribes."""
    return f"""\
import rclpy
from rclpy.node import Node
from std_msgs.msg import {type}


class Listener(Node):
    def __init__(self):
        super().__init__('listener')
        self.sub = self.create_subscription({type}, '{topic}', self.on_text, 10)

    def on_text(self, msg):
        self.get_logger().info(str(msg.data))


def main():
    rclpy.init()
    rclpy.spin(Listener())
"""


TALKER, LISTENER = talker(), listener()


def _started(*names: str) -> str:
    nodes = "\n".join(
        f'  <node pkg="demo_nodes_py" exec="talker" name="{name}"/>' for name in names
    )
    return f"<launch>\n{nodes}\n</launch>\n"


NAMED_TWICE = {
    "bad": {"two.launch.xml": _started("talker", "talker")},
    "good": {"two.launch.xml": _started("talker", "other_talker")},
}


_PACKAGE = """\
<package format="3">
  <name>demo</name>
  <version>0.1.0</version>
  <description>Two nodes</description>
  <maintainer email="someone@example.org">Someone</maintainer>
  <license>MIT</license>
{depends}  <export><build_type>ament_python</build_type></export>
</package>
"""
_SETUP = """\
from setuptools import setup

setup(
    name='demo',
    version='0.1.0',
    packages=['demo'],
    entry_points={
        'console_scripts': [
            'talker = demo.talker:main',
            'listener = demo.listener:main',
        ],
    },
)
"""


SETUP_CFG = "[develop]\nscript_dir=$base/lib/demo\n[install]\ninstall_scripts=$base/lib/demo\n"


def _package(launch: str, *, listens_to: str = "chatter") -> dict[str, str]:
    """Return the package of both nodes, with what a launch file of it says."""
    depends = "".join(f"  <depend>{name}</depend>\n" for name in ("rclpy", "std_msgs"))
    return {
        "demo/package.xml": _PACKAGE.format(depends=depends),
        "demo/setup.py": _SETUP,
        "demo/setup.cfg": SETUP_CFG,
        "demo/demo/__init__.py": "",
        "demo/demo/talker.py": TALKER,
        "demo/demo/listener.py": listener(topic=listens_to),
        "demo/launch/both.launch.xml": f"<launch>\n{launch}</launch>\n",
    }


def _both(*, namespace: str = "", remapped: str = "chatter") -> str:
    attribute = f' namespace="{namespace}"' if namespace else ""
    return f"""\
  <node pkg="demo" exec="talker" name="talker"{attribute}/>
  <node pkg="demo" exec="listener" name="listener">
    <remap from="{remapped}" to="chatter"/>
  </node>
"""


REMAPPED = {
    "bad": _package(_both(remapped="text"), listens_to="texts"),
    "good": _package(_both(remapped="texts"), listens_to="texts"),
}
MOVED = {
    "bad": _package(_both(namespace="robot")),
    "good": _package(_both()),
}
