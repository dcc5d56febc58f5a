"""Programs that load nodes, generated again and again into one folder."""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from typing import NamedTuple

from file_sets import one

from plastron_tui.diagnostics import Severity
from plastron_tui.output.writer import write
from plastron_tui.session import Options, Session
from plastron_tui.targets import read_source

MESSAGES = """\
create_message hello of message_type String and input "hello"
create_message five of message_type Int32 and input 5
"""

ROSPY = '''\
#!/usr/bin/env python3
"""A node that somebody wrote."""
import rospy
from std_msgs.msg import String
from std_srvs.srv import Empty, EmptyResponse


def on_command(msg):
    rospy.loginfo(msg.data)


def on_reset(request):
    return EmptyResponse()


def main():
    rospy.init_node("robot")
    status = rospy.Publisher("status", String, queue_size=10)
    rospy.Subscriber("command", String, on_command)
    rospy.Service("reset", Empty, on_reset)
    on_command(String("start"))
    rate = rospy.Rate(5)
    while not rospy.is_shutdown():
        status.publish("fine")
        rate.sleep()


main()
'''

RCLPY = '''\
#!/usr/bin/env python3
"""A node that somebody wrote."""
import rclpy
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Empty


class Robot(Node):
    def __init__(self):
        super().__init__("robot")
        self.status = self.create_publisher(String, "status", 10)
        self.create_subscription(String, "command", self.on_command, 10)
        self.create_service(Empty, "reset", self.on_reset)
        self.create_timer(0.2, self.tick)
        self.on_command(String(data="start"))

    def on_command(self, msg):
        self.get_logger().info(msg.data)

    def on_reset(self, request, response):
        return response

    def tick(self):
        self.status.publish(String(data="fine"))


def main():
    rclpy.init()
    rclpy.spin(Robot())


main()
'''

NODES = {"rospy": ROSPY, "rclpy": RCLPY}
LIBRARIES = tuple(NODES)

# How a node is loaded: the statement, where the node is, where it is written, whether in place.
WAYS = {
    "by its name, beside the program": ("load robot as n", "robot.py", "output/robot.py", False),
    "by its name, in the output": ("load robot as n", "output/robot.py", "output/robot.py", False),
    "by its path": ("load 'nodes/robot.py' as n", "nodes/robot.py", "output/robot.py", False),
    "in place": ("load 'nodes/robot.py' as n", "nodes/robot.py", "nodes/robot.py", True),
    "by its name, in place": ("load robot as n", "robot.py", "robot.py", True),
    "by its path, in the output": (
        "load 'output/robot.py' as n", "output/robot.py", "output/robot.py", False,
    ),
    "in place, in the output": (
        "load 'output/robot.py' as n", "output/robot.py", "output/robot.py", True,
    ),
}  # fmt: skip


class Outcome(NamedTuple):
    """What a `generate` did: the state of each file, warnings, conflicts, errors."""

    states: list[str]
    warnings: list[str]
    conflicts: list[str]
    errors: list[str]


class Bench:
    """A folder with programs, nodes that somebody wrote, and what is generated."""

    def __init__(self, path: Path, library: str = "rospy") -> None:
        self.path, self.library = path, library

    def put(self, name: str, text: str | None = None) -> Path:
        """Write a node by hand."""
        file = self.path / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(NODES[self.library] if text is None else text)
        return file

    def session(
        self,
        text: str,
        program: str = "robot.plastron",
        output: str | None = "output",
        *,
        in_place: bool = False,
        force: bool = False,
    ) -> Session:
        folder = None if output is None else self.path / output
        options = Options(self.library, folder, in_place=in_place, force=force)
        return Session(f"{MESSAGES}{text}".encode(), self.path / program, options, environ={})

    def generate(
        self,
        text: str,
        program: str = "robot.plastron",
        output: str | None = "output",
        *,
        in_place: bool = False,
        force: bool = False,
    ) -> Outcome:
        """Generate, as `plastron generate` does."""
        session = self.session(text, program, output, in_place=in_place, force=force)
        found = session.diagnostics
        errors = [each for each in found if each.severity is Severity.ERROR]
        if errors:
            return Outcome([], [], [], [f"{each.code}: {each.message}" for each in errors])
        plan, told = session.plan()
        errors = [each for each in told if each.severity is Severity.ERROR]
        if not errors and (force or not plan.conflicts):
            assert write(plan, force=force).diagnostics == ()
        return Outcome(
            [file.state.value for file in plan.files],
            [f"{each.code}: {each.message}" for each in told if each not in errors],
            [f"{each.code}: {each.message}" for each in plan.conflicts],
            [f"{each.code}: {each.message}" for each in errors],
        )

    def files(self) -> dict[str, bytes]:
        """Return all files but for the manifests."""
        return {
            path.relative_to(self.path).as_posix(): path.read_bytes()
            for path in sorted(self.path.rglob("*"))
            if path.is_file()
        }

    def edit(self, name: str, old: str, new: str) -> None:
        """Change a file by hand."""
        text = (self.path / name).read_text()
        assert text.count(old) == 1, text
        (self.path / name).write_text(text.replace(old, new))


def shown(path: Path) -> Counter[tuple[str, str | None]]:
    """Return kind and name of all that a file creates, but for timers."""
    source = read_source(path, one(path.read_bytes())).source
    assert source is not None
    return Counter(
        (each.kind.value, each.name)
        for node in source.nodes
        for each in node.endpoints
        if each.kind.value != "timers"
    )
