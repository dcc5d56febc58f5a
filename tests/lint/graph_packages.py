"""A package of a talker and a listener, with launch files, and what the linter tells of it."""

from __future__ import annotations

from pathlib import Path

from linted import run_over, told, write_tree

PACKAGE_XML = (
    '<package format="3"><name>demo</name><version>0.1.0</version><description>x</description>'
    '<maintainer email="a@b.org">A</maintainer><license>MIT</license>'
    "<export><build_type>ament_python</build_type></export></package>"
)
SETUP = (
    "from setuptools import setup\nsetup(name='demo', packages=['demo'], entry_points={\n"
    "    'console_scripts': ['talker = demo.talker:main', 'listener = demo.listener:main']})\n"
)
TALKER = """\
import rclpy
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy, qos_profile_sensor_data
from std_msgs.msg import Int32, String

class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        {before}
        self.pub = self.create_publisher({type}, '{topic}', {qos})
        {more}
"""
LISTENER = """\
import rclpy
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy, qos_profile_sensor_data
from std_msgs.msg import Int32, String

class Listener(Node):
    def __init__(self):
        super().__init__('listener')
        {before}
        self.sub = self.create_subscription({type}, '{topic}', self.on_text, {qos})

    def on_text(self, msg):
        pass
"""


def code_of(template: str, **words: str) -> str:
    """Return a node with other words than usual."""
    usual = {"type": "String", "topic": "chatter", "qos": "10", "before": "pass", "more": "pass"}
    return template.format(**usual | words)


def package_of(talker: str = "", listener: str = "", **launches: str) -> dict[str, str | bytes]:
    """Return a package of two nodes, with launch files by what they are called and written in."""
    names = {"py": ".launch.py", "xml": ".launch.xml", "yaml": ".launch.yaml"}
    return {
        "demo/package.xml": PACKAGE_XML,
        "demo/setup.py": SETUP,
        "demo/demo/talker.py": talker or code_of(TALKER),
        "demo/demo/listener.py": listener or code_of(LISTENER),
        **{
            f"demo/launch/{key.partition('_')[0]}{names[key.rpartition('_')[2]]}": text
            for key, text in launches.items()
        },
    }


def alone(name: str, needs: str, code: str) -> dict[str, str | bytes]:
    """Return a package of one node that no launch file starts."""
    depend = f"<license>MIT</license><depend>{needs}</depend>"
    xml = PACKAGE_XML.replace("demo<", f"{name}<").replace("<license>MIT</license>", depend)
    setup = f"from setuptools import setup\nsetup(name='{name}', packages=['{name}'])\n"
    return {
        f"{name}/package.xml": xml,
        f"{name}/setup.py": setup,
        f"{name}/{name}/node.py": code,
    }


def in_python(*lines: str) -> str:
    """Return a launch file in Python; what it starts stands in its third line and those below."""
    body = "\n".join(f"    {line}," for line in lines)
    start = (
        "from all_of_it import *\ndef generate_launch_description(): return LaunchDescription([\n"
    )
    return f"{start}{body}\n])\n"


def node_of(executable: str, *words: str) -> str:
    """Return what starts a node in a launch file in Python."""
    said = "".join(f", {word}" for word in words)
    return f"Node(package='demo', executable='{executable}'{said})"


def found_in(
    folder: Path, files: dict[str, str | bytes], *select: str
) -> list[tuple[str, str, int]]:
    """Return the codes of what is told, each with the name of the file, and the line."""
    run = run_over(write_tree(folder, files), *select)
    names = [each.diagnostic.file.name for each in run.told if each.diagnostic.file is not None]
    return [(code, name, line) for (code, line), name in zip(told(run), names, strict=True)]
