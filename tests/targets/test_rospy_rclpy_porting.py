"""Bringing nodes from one ROS to the other: before and after, and what holds for every node."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
from collections import Counter
from pathlib import Path

import pytest

from plastron_tui.diagnostics import Diagnostic, Severity
from plastron_tui.model.source import EndpointKind, SourceFile
from plastron_tui.output.plan import FileState
from plastron_tui.ros.catalog import Catalog
from plastron_tui.session import Options, Session
from plastron_tui.targets import find_target
from plastron_tui.targets.python import read_python

CATALOGS = {"rospy": Catalog("noetic"), "rclpy": Catalog("kilted")}
OTHER = {"rospy": "rclpy", "rclpy": "rospy"}
NODES = Path(__file__).parent.parent / "nodes"
FILES = sorted(
    path
    for path in NODES.glob("r*py/*")
    if path.is_file() and path.suffix != ".json" and path.parent.name in OTHER
)
KINDS = {
    EndpointKind.PUBLISHER,
    EndpointKind.SUBSCRIPTION,
    EndpointKind.SERVICE,
    EndpointKind.CLIENT,
}
MARK = "# port by hand: "

LISTENER_1 = '''\
#!/usr/bin/env python
"""Hears things."""

import rospy
from std_msgs.msg import String

LOUD = "!"


def shout(text):
    return text.upper() + LOUD


def callback(data):
    text = shout(data.data)
    rospy.loginfo(rospy.get_caller_id() + "I heard %s", text)


def listener():
    rospy.init_node("listener", anonymous=True)
    rospy.Subscriber("chatter", String, callback)
    # spin() simply keeps python from exiting
    rospy.spin()


if __name__ == "__main__":
    listener()
'''
LISTENER_2 = '''\
#!/usr/bin/env python3
"""Hears things."""

import rclpy
from rclpy.executors import ExternalShutdownException
from std_msgs.msg import String

node = None


def spin():
    """Handle what comes, until ROS ends."""
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


LOUD = "!"


def shout(text):
    return text.upper() + LOUD


def callback(data):
    text = shout(data.data)
    # port by hand: rospy.loginfo; rospy.get_caller_id
    rospy.loginfo(rospy.get_caller_id() + "I heard %s", text)


def listener():
    global node
    rclpy.init()
    # port by hand: anonymous
    node = rclpy.create_node("listener")
    node.create_subscription(String, "chatter", callback, 10)
    # spin() simply keeps python from exiting
    spin()


if __name__ == "__main__":
    listener()
'''
SERVER_1 = """\
import rospy
from beginner_tutorials.srv import AddTwoInts, AddTwoIntsResponse
from geometry_msgs.msg import PointStamped


class Adder:
    def __init__(self):
        self.calls = 0
        self.points = rospy.Publisher("~points", PointStamped, queue_size=5)
        rospy.Service("add", AddTwoInts, self.add)
        rospy.Timer(rospy.Duration(0.5), self.tick)

    def add(self, req):
        self.calls += 1
        return AddTwoIntsResponse(sum=req.a + req.b)

    def tick(self, event):
        point = PointStamped()
        point.header.stamp = rospy.Time.now()
        if point.header.stamp.secs > 5:
            self.points.publish(point)


if __name__ == "__main__":
    rospy.init_node("adder")
    Adder()
    rospy.spin()
"""
SERVER_2 = '''\
import rclpy
from rclpy.executors import ExternalShutdownException
from example_interfaces.srv import AddTwoInts
from geometry_msgs.msg import PointStamped

AddTwoIntsResponse = AddTwoInts.Response


def spin():
    """Handle what comes, until ROS ends."""
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


class Adder:
    def __init__(self):
        self.calls = 0
        self.points = node.create_publisher(PointStamped, "~/points", 5)
        node.create_service(AddTwoInts, "add", self.add)
        node.create_timer(0.5, self.tick)

    def add(self, req, response=None):
        self.calls += 1
        return AddTwoIntsResponse(sum=req.a + req.b)

    def tick(self, event=None):
        point = PointStamped()
        # port by hand: rospy.Time.now
        point.header.stamp = rospy.Time.now()
        # port by hand: .secs
        if point.header.stamp.secs > 5:
            self.points.publish(point)


if __name__ == "__main__":
    rclpy.init()
    node = rclpy.create_node("adder")
    Adder()
    spin()
'''
ROBOT_2 = '''\
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import SetBool


class Robot(Node):
    """A robot."""

    def __init__(self):
        super().__init__("robot")
        self.publisher = self.create_publisher(String, "chatter", 10)
        self.create_subscription(String, "orders", self.on_order, 5)
        self.create_service(SetBool, "~/power", self.on_power)
        self.create_timer(0.5, self.tick)

    def on_order(self, message):
        self.get_logger().info(message.data)

    def on_power(self, request, response):
        """Switch it."""
        response.success = request.data
        return response

    def tick(self):
        self.publisher.publish(String(data="hello"))


def main(args=None):
    rclpy.init(args=args)
    robot = Robot()
    try:
        rclpy.spin(robot)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        robot.destroy_node()
        rclpy.try_shutdown()
'''
ROBOT_1 = '''\
import rospy
from std_srvs.srv import SetBoolResponse
from std_msgs.msg import String
from std_srvs.srv import SetBool


class Robot:
    """A robot."""

    def __init__(self):
        rospy.init_node("robot")
        self.publisher = rospy.Publisher("chatter", String, queue_size=10)
        rospy.Subscriber("orders", String, self.on_order, queue_size=5)
        rospy.Service("~power", SetBool, self.on_power)
        rospy.Timer(rospy.Duration(0.5), self.tick)

    def on_order(self, message):
        # port by hand: .get_logger
        self.get_logger().info(message.data)

    def on_power(self, request):
        """Switch it."""
        response = SetBoolResponse()
        response.success = request.data
        return response

    def tick(self, event=None):
        self.publisher.publish(String(data="hello"))


def main(args=None):
    robot = Robot()
    try:
        rospy.spin()
    except (KeyboardInterrupt, rospy.ROSInterruptException):
        pass
    finally:
        rospy.signal_shutdown("the node is done")
'''
WHOLE = {
    "rospy listener": ("rospy", LISTENER_1, LISTENER_2),
    "rospy server": ("rospy", SERVER_1, SERVER_2),
    "rclpy robot": ("rclpy", ROBOT_2, ROBOT_1),
}

# A statement of a rospy node, and what becomes of it.
HEAD_1 = """\
import rospy
from std_msgs.msg import String
from std_srvs.srv import *

rospy.init_node('n')
"""
TO_RCLPY = [
    (
        "rospy.Subscriber('t', String)",
        "node.create_subscription(String, 't', lambda message: None, 10)",
    ),
    (
        "rospy.Subscriber('t', String, print, 'extra', queue_size=1)",
        "node.create_subscription(String, 't', lambda message: print(message, 'extra'), 1)",
    ),
    (
        "rospy.Publisher('t', String, queue_size=None, latch=True)",
        f"{MARK}latch\nnode.create_publisher(String, 't', 10)",
    ),
    ("p = rospy.ServiceProxy('s', Trigger)", "p = node.create_client(Trigger, 's')"),
    (
        "rospy.Service('s', Trigger, lambda r: (True, ''))",
        "node.create_service(Trigger, 's', "
        "lambda request, response: (lambda r: (True, ''))(request))",
    ),
    (
        "rospy.Timer(rospy.Duration(secs=2), lambda e: print(e))",
        "node.create_timer(2, lambda: (lambda e: print(e))(None))",
    ),
    (
        "m = rospy.wait_for_message('t', String, timeout=5)",
        "m = wait_for_message(String, node, 't', time_to_wait=5)[1]",
    ),
    ("if rospy.is_shutdown(): pass", "if not rclpy.ok(): pass"),
    ("go = not rospy.is_shutdown()", "go = rclpy.ok()"),
    ("rate = rospy.Rate(10)", "rate = node.create_rate(10)"),
    ("x = rospy.get_param('~x', 1)", f"{MARK}rospy.get_param\nx = rospy.get_param('~x', 1)"),
    (
        "t = rospy.Time.now().to_sec()",
        f"{MARK}.to_sec; rospy.Time.now\nt = rospy.Time.now().to_sec()",
    ),
    (
        "pub = rospy.Publisher('t', String, queue_size=1)\npub.publish('hello')",
        "pub = node.create_publisher(String, 't', 1)\n"
        f"{MARK}publish takes a message\npub.publish('hello')",
    ),
    (
        "s = String('hello')",
        f"{MARK}String takes keywords only\ns = String('hello')",
    ),
    (
        "p = rospy.ServiceProxy('s', Trigger)\nanswer = p()",
        f"p = node.create_client(Trigger, 's')\n{MARK}the call of p\nanswer = p()",
    ),
    (
        "p = rospy.ServiceProxy('s', Trigger)\n\n\ndef ask(client):\n    return client()",
        "p = node.create_client(Trigger, 's')\n\n\ndef ask(client):\n"
        f"    {MARK}the call of client\n    return client()",
    ),
]


def source(text: str | bytes, library: str) -> SourceFile:
    data = text.encode() if isinstance(text, str) else text
    found = read_python(Path("node.py"), data, library).source
    assert found is not None
    return found


def ported(text: str | bytes, library: str) -> tuple[str, tuple[Diagnostic, ...]]:
    """Bring a file to the other client library."""
    target = find_target(OTHER[library])
    assert target is not None
    read = source(text, library)
    result = target.port(None, read, CATALOGS[OTHER[library]])  # type: ignore[arg-type]
    assert result.text is not None, result.diagnostics
    return result.text.decode("utf-8", "replace"), result.diagnostics


@pytest.mark.parametrize(("library", "before", "after"), WHOLE.values(), ids=WHOLE)
def test_a_whole_file(library: str, before: str, after: str) -> None:
    assert ported(before, library)[0] == after


@pytest.mark.parametrize(("library", "before", "after"), WHOLE.values(), ids=WHOLE)
def test_what_is_new_is_as_ruff_formats_it(library: str, before: str, after: str) -> None:
    formatted = subprocess.run(
        [sys.executable, "-m", "ruff", "format", "--isolated", "-"],
        input=after,
        capture_output=True,
        text=True,
        check=True,
    )
    assert formatted.stdout == after


@pytest.mark.parametrize(("before", "after"), TO_RCLPY)
def test_a_statement_of_rospy(before: str, after: str) -> None:
    text, _ = ported(HEAD_1 + before + "\n", "rospy")
    assert f"\n{after}\n" in text


def endpoints(read: SourceFile) -> Counter[tuple[EndpointKind, str]]:
    return Counter(
        (each.kind, each.name.replace("~/", "~"))
        for node in read.nodes
        for each in node.endpoints
        if each.kind in KINDS and each.name is not None
    )


def callbacks(read: SourceFile) -> set[str]:
    return {
        each.callback
        for node in read.nodes
        for each in node.endpoints
        if each.callback is not None and each.kind in KINDS | {EndpointKind.TIMER}
    }


@pytest.mark.parametrize("path", FILES, ids=lambda path: f"{path.parent.name}/{path.stem}")
def test_every_node_of_the_collection(path: Path) -> None:
    read = read_python(path, path.read_bytes(), None).source
    if read is None or read.library not in OTHER:
        return
    target = find_target(OTHER[read.library])
    assert target is not None
    result = target.port(None, read, CATALOGS[target.name])  # type: ignore[arg-type]
    if result.text is None:
        assert [found.code for found in result.diagnostics] == ["edit-refused"]
        with pytest.raises((SyntaxError, ValueError)):
            ast.parse(read.text)
        return
    assert all(
        found.code == "port-by-hand" and found.severity is Severity.WARNING and found.file == path
        for found in result.diagnostics
    )
    check_endpoints(read, result.text, result.diagnostics, target.name)
    check_marks(read, result.text, result.diagnostics)
    check_bodies(read, result.text)


def check_endpoints(
    read: SourceFile, text: bytes, diagnostics: tuple[Diagnostic, ...], library: str
) -> None:
    """What the file shows is what it showed, apart from what is said to be missing."""
    after = read_python(read.path, text, library).source
    assert after is not None
    missing = Counter(
        match[1].replace("~/", "~")
        for found in diagnostics
        if (match := re.search(r"`(.*)` in line \d+ is not carried over", found.message))
    )
    before = Counter(name for _, name in endpoints(read).elements())
    assert Counter(name for _, name in endpoints(after).elements()) >= before - missing


def check_marks(read: SourceFile, text: bytes, diagnostics: tuple[Diagnostic, ...]) -> None:
    """Every statement that still names the old library stands below a comment."""
    try:
        tree = ast.parse(text)
    except (SyntaxError, ValueError):
        return
    lines = text.decode("utf-8", "replace").split("\n")
    statements = [node for node in ast.walk(tree) if isinstance(node, ast.stmt)]
    for node in ast.walk(tree):
        if isinstance(node, ast.Name) and node.id == read.library:
            around = {
                s.lineno for s in statements if s.lineno <= node.lineno <= (s.end_lineno or 0)
            }
            above = {lines[row - 2] for row in (*around, node.lineno)}
            assert any(MARK in line for line in above), lines[node.lineno - 1]
    named = {
        what
        for line in lines
        if MARK in line
        for what in line.partition(MARK)[2].strip().split("; ")
    }
    told = {found.message.split("`")[1] for found in diagnostics if "`" in found.message}
    assert named - told == set() or MARK.encode() in read.text


def check_bodies(read: SourceFile, text: bytes) -> None:
    """Every statement of a callback that makes no endpoint is as it was."""
    try:
        before, after = ast.parse(read.text), ast.parse(text)
    except (SyntaxError, ValueError):
        return
    makers = re.compile(
        r"Publisher\(|Subscriber\(|Service\(|ServiceProxy\(|Timer\(|create_|wait_for_m"
    )
    for name in callbacks(read):
        new = {
            ast.unparse(statement)
            for function in functions(after, name)
            for statement in function.body
        }
        for function in functions(before, name):
            for statement in function.body:
                written = ast.unparse(statement)
                if not makers.search(written) and "import" not in written:
                    assert written in new


def functions(tree: ast.AST, name: str) -> list[ast.FunctionDef | ast.AsyncFunctionDef]:
    return [
        node
        for node in ast.walk(tree)
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)) and node.name == name
    ]


def test_there_and_back_shows_the_same_endpoints() -> None:
    for library, before, _ in WHOLE.values():
        there, _ = ported(before, library)
        back, _ = ported(there, OTHER[library])
        assert endpoints(source(back, library)) == endpoints(source(before, library))


def test_windows_line_ends_stay() -> None:
    text, _ = ported(LISTENER_1.replace("\n", "\r\n"), "rospy")
    assert text == LISTENER_2.replace("\n", "\r\n")


def test_a_file_that_does_not_parse_is_refused() -> None:
    target = find_target("rclpy")
    assert target is not None
    read = source(LISTENER_1.replace("def listener():", "def listener(:"), "rospy")
    result = target.port(None, read, CATALOGS["rclpy"])  # type: ignore[arg-type]
    assert result.text is None
    assert [found.code for found in result.diagnostics] == ["edit-refused"]


def test_a_name_that_the_file_decides_is_listed() -> None:
    text, found = ported(HEAD_1 + "rospy.Publisher(rospy.resolve_name('x'), String)\n", "rospy")
    assert "the name rospy.resolve_name('x')" in text
    assert any("the name rospy.resolve_name('x')" in each.message for each in found)


def test_a_type_that_the_other_ros_lacks_is_marked() -> None:
    text, found = ported(
        "import rospy\nfrom rosgraph_msgs.msg import TopicStatistics\n\nrospy.init_node('n')\n"
        "rospy.Subscriber('s', TopicStatistics)\n",
        "rospy",
    )
    assert f"{MARK}rosgraph_msgs/TopicStatistics\nfrom rosgraph_msgs" in text
    assert found[0].help == "ROS 2 has statistics in `statistics_msgs`"


class TestThroughAProgram:
    """A `load` and a `generate_node … using`, as a program has them."""

    def session(self, folder: Path, program: str, output: Path | None = None) -> Session:
        (folder / "listener.py").write_text(LISTENER_1)
        return Session(program.encode(), folder / "p.plastron", Options(output=output), environ={})

    def test_the_file_is_of_the_same_name_in_the_output_folder(self, tmp_path: Path) -> None:
        session = self.session(tmp_path, "load listener as x\ngenerate_node x using rclpy\n")
        assert session.diagnostics == ()
        [made] = session.generated()
        assert made.file is not None
        assert made.file.name == "listener.py"
        assert made.file.text.decode() == LISTENER_2
        assert [found.span is not None for found in made.diagnostics] == [True] * 3
        lines = made.file.text.decode().split("\n")
        for found in made.diagnostics:
            match = re.match(r"`(.*)` in line (\d+) of the new file", found.message)
            assert match is not None
            assert match[1] in lines[int(match[2]) - 2]

    def test_what_the_program_changes_is_in_it(self, tmp_path: Path) -> None:
        session = self.session(
            tmp_path,
            "load listener as x\n"
            "unsubscribe x from 'chatter'\n"
            "subscribe x to 'other' of message_type String\n"
            "generate_node x using rclpy\n",
        )
        assert session.diagnostics == ()
        [made] = session.generated()
        assert made.file is not None
        found = endpoints(source(made.file.text, "rclpy"))
        assert found == {(EndpointKind.SUBSCRIPTION, "other"): 1}

    def test_a_loaded_node_keeps_its_library_otherwise(self, tmp_path: Path) -> None:
        session = self.session(tmp_path, "load listener as x\ngenerate_node x\n")
        session.options = session.options._replace(target="rclpy")
        [made] = session.generated()
        assert made.file is not None
        assert made.file.text.decode() == LISTENER_1

    def test_the_file_that_was_loaded_is_never_overwritten(self, tmp_path: Path) -> None:
        program = "load listener as x\ngenerate_node x using rclpy\n"
        session = self.session(tmp_path, program, tmp_path)
        plan, _ = session.plan()
        assert [file.state for file in plan.files] == [FileState.CONFLICT]
