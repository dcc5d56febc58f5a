"""What lint says of nodes whose class derives from one of another file."""

from __future__ import annotations

from pathlib import Path
from textwrap import dedent, indent

import pytest
from linted import run_over, write_tree

from plastron_tui.lint.rules.package_examples import package_xml, setup_py

_BASE = """\
from rclpy.node import Node
from std_msgs.msg import String


class Base(Node):
    def __init__(self, name, default_rate=10.0):
        super().__init__(name)
        self.declare_parameter('rate', default_rate)
        rate = self.get_parameter('rate').value
        self.poll_timer = self.create_timer(1.0 / rate, self.poll)
        self.sub = self.create_subscription(String, 'heard', self.on_text, 10)
        {made}

    def poll(self):
        raise NotImplementedError

    def on_text(self, msg):
        self.get_logger().info(msg.data)
"""
_NODE = """\
import time

import rclpy
from {module} import Base
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
from std_msgs.msg import Bool


class Talker(Base):
    def __init__(self):
        super().__init__('talker'{given})

{methods}


def main():
    rclpy.init()
{main}
"""
_SPIN = "rclpy.spin(Talker())"
_POLL = "def poll(self):\n    pass"


def _files(
    methods: str = _POLL, main: str = _SPIN, made: str = "", given: str = "", bases: str = "demo"
) -> dict[str, str]:
    """Return a workspace with a node, and a base class in its package or in another one."""
    methods, main = (dedent(each).strip("\n") for each in (methods, main))
    node = _NODE.format(
        module=f"{bases}.base",
        given=given,
        methods=indent(methods, " " * 4),
        main=indent(main, " " * 4),
    )
    files = {"demo/demo/talker.py": node, f"{bases}/{bases}/base.py": _BASE.format(made=made)}
    for name in ("demo", bases):
        files[f"{name}/package.xml"] = package_xml(name)
        files[f"{name}/{name}/__init__.py"] = ""
    return files


def _told(root: Path, code: str) -> list[tuple[str, str]]:
    """Return the names of the files that break a rule, each with the line."""
    run = run_over(root, code)
    found = []
    for each in run.told:
        span, file = each.diagnostic.span, each.diagnostic.file
        assert file is not None
        assert span is not None
        text = file.read_text()
        line = text.splitlines()[text[: span.start].count("\n")].strip()
        found.append((file.name, line))
    return found


_KEPT = (
    f"{_POLL}\n\ndef reset(self):\n    self.kept = None\n\ndef say(self):\n    Bool(data=self.kept)"
)
_CASES = [
    ("RC402", {"methods": "def poll(self):\n    time.sleep(1.0)  # wrong"}),
    ("RC402", {"methods": "def poll(self):\n    self.wait()\n\n"
               "def wait(self):\n    time.sleep(1.0)  # wrong"}),
    # Not what the base hands over.
    ("RC402", {"methods": f"{_POLL}\n\ndef other(self):\n    time.sleep(1.0)"}),
    ("RC402", {"methods": f"{_POLL}\n\ndef other(self):\n    time.sleep(1.0)  # wrong",
               "made": "self.create_timer(1.0, self.other)"}),
    # Only some nodes of the base have it.
    ("RC402", {"methods": f"{_POLL}\n\ndef other(self):\n    time.sleep(1.0)",
               "made": "if default_rate > 20:\n            self.create_timer(1.0, self.other)"}),
    # Another thread calls the others meanwhile.
    ("RC402", {"methods": "def poll(self):\n    time.sleep(1.0)",
               "main": "executor = MultiThreadedExecutor()\nexecutor.add_node(Talker())\n"
               "executor.spin()"}),
    ("RC403", {"methods": "def poll(self, event):  # wrong\n    pass"}),
    ("RC403", {"methods": f"{_POLL}\n\ndef on_text(self):  # wrong\n    pass"}),
    ("RC403", {"methods": f"{_POLL}\n\ndef on_text(self, msg, info):\n    pass"}),
    # The base hands something else over, or the node has something else by the name.
    ("RC403", {"methods": "def poll(self, event):\n    pass\n\n"
               "def change(self):\n    self.poll = print"}),
    ("RC403", {"methods": "@staticmethod\ndef poll():\n    pass"}),
    ("RC404", {"methods": "def poll(self):\n    self.say()\n\ndef say(self):\n"
               "    self.create_publisher(Bool, 'low', 10)  # wrong"}),
    ("RC404", {"methods": f"{_POLL}\n\ndef say(self):\n"
               "    self.create_publisher(Bool, 'low', 10)"}),
    ("RC405", {"main": "node = Talker()  # wrong\nnode.destroy_node()"}),
    ("RC405", {"main": "node = Talker()  # wrong\nexecutor = SingleThreadedExecutor()\n"
               "executor.add_node(node)\nexecutor.spin"}),
    ("RC405", {"main": "node = Talker()  # wrong\nrclpy.spin"}),
    ("RC405", {"main": "node = Talker()\nspin = rclpy.spin\nspin(node)"}),
    # The base may spin it, or have it spun.
    ("RC405", {"main": "node = Talker()", "made": "self.spin_it()"}),
    ("RC405", {"main": "node = Talker()", "made": "Helper(self)"}),
    # What only one of the two gives a value.
    ("RM202", {"methods": f"{_KEPT}  # wrong"}),
    ("RM202", {"methods": f"{_KEPT}  # wrong", "made": "self.kept = None"}),
    ("RM202", {"methods": _KEPT, "made": "self.kept = True"}),
]  # fmt: skip


@pytest.mark.parametrize("bases", ["demo", "bases"])
@pytest.mark.parametrize(("code", "parts"), _CASES)
def test_what_a_base_class_creates_counts(
    code: str, parts: dict[str, str], bases: str, tmp_path: Path
) -> None:
    files = _files(**parts, bases=bases)
    lines = files["demo/demo/talker.py"].splitlines()
    wrong = [("talker.py", each.strip()) for each in lines if each.endswith("# wrong")]
    assert _told(write_tree(tmp_path, files), code) == wrong


def test_a_base_class_that_is_not_read_says_nothing(tmp_path: Path) -> None:
    files = _files("def poll(self, event):\n    time.sleep(1.0)", "node = Talker()")
    del files["demo/demo/base.py"]
    root = write_tree(tmp_path, files)
    assert [_told(root, code) for code in ("RC402", "RC403", "RC405")] == [[], [], []]


def _launched(inner: str) -> str:
    return f'<launch><node pkg="demo" exec="talker" name="talker">{inner}</node></launch>'


@pytest.mark.parametrize(("made", "is_told"), [("", True), ("Helper(self)", False)])
def test_nodes_whose_bases_are_read_have_no_other_names(
    made: str, is_told: bool, tmp_path: Path
) -> None:
    files = _files(made=made)
    files["demo/setup.py"] = setup_py("talker = demo.talker:main")
    files["demo/launch/a.launch.xml"] = _launched('<remap from="foo" to="x"/>')
    assert bool(_told(write_tree(tmp_path, files), "RG105")) == is_told


@pytest.mark.parametrize(
    ("given", "made", "value", "wrong"),
    [
        # The base says 10.0, its class of the node something else.
        ("", "", "50", True),
        ("", "", "50.0", False),
        (", default_rate=2.0", "", "50", True),
        (", 2.0", "", "50", True),
        (", default_rate=2", "", "50", False),
        (", 2", "", "50.0", True),
        (", **{}", "", "50", False),
        (", default_rate=unknown()", "", "50", False),
        ("", "default_rate = 2", "50", False),
        ("", "self.declare_parameter('x', descriptor=D(dynamic_typing=True))", "50", False),
    ],
)
def test_what_a_base_is_given_decides_the_type_of_a_parameter(
    given: str, made: str, value: str, wrong: bool, tmp_path: Path
) -> None:
    files = _files(given=given, made=made)
    files["demo/setup.py"] = setup_py("talker = demo.talker:main")
    files["demo/launch/a.launch.xml"] = _launched(f'<param name="rate" value="{value}"/>')
    assert bool(_told(write_tree(tmp_path, files), "RP303")) == wrong


@pytest.mark.parametrize(
    ("declared", "is_told"), [("", True), ("self.declare_parameter('frame', '')", False)]
)
def test_what_neither_base_nor_node_declares_is_told_of(
    declared: str, is_told: bool, tmp_path: Path
) -> None:
    made = "self.frame = self.get_parameter('frame').value"
    files = _files(f"{_POLL}\n\ndef more(self):\n    {declared or 'pass'}", made=made)
    expected = [("base.py", made)] if is_told else []
    assert _told(write_tree(tmp_path, files), "RP304") == expected


@pytest.mark.parametrize(
    "lines",
    [
        ["node = Talker()  # wrong", "node.get_logger().info('up')", "node.destroy_node()"],
        ["Talker()  # wrong"],
        ["node = None", "try:", "    node = Talker()  # wrong", "finally:", "    if node:",
         "        node.destroy_node()"],
        ["node = Talker()  # wrong", "if node is not None and not rclpy.ok():",
         "    node.destroy_node()"],
        ["node = Talker()  # wrong", "node.trigger_configure()", "node.trigger_activate()"],
        ["node = Talker()", "if work(node):", "    node.destroy_node()"],
        ["node = Talker()", "if node.work():", "    node.destroy_node()"],
        ["node = Talker()", "nodes = [node]"],
        ["node = Talker()  # wrong", "executor = SingleThreadedExecutor()",
         "executor.add_node(node)", "executor.spin"],
        ["node = Talker()", "rclpy.spin(node)"],
        ["node = Talker()", "node.work()"],
        ["return Talker()"],
        ["helper(Talker())"],
        ["rclpy.spin(Talker())"],
        ["node = Other()"],
    ],
)  # fmt: skip
def test_a_node_of_another_file_that_nothing_spins_is_told(
    lines: list[str], tmp_path: Path
) -> None:
    head = "import rclpy\nfrom demo.talker import Other, Talker\n"
    head += "from rclpy.executors import SingleThreadedExecutor\n\n\ndef main():\n"
    run = head + indent("\n".join(["rclpy.init()", *lines]), " " * 4) + "\n"
    other = "\n\nclass Other(Talker):\n    def go(self):\n        rclpy.spin(self)\n"
    files = _files()
    files["demo/demo/talker.py"] += other
    files["demo/demo/run.py"] = run
    wrong = [("run.py", each.strip()) for each in lines if each.endswith("# wrong")]
    assert _told(write_tree(tmp_path, files), "RC405") == wrong


_STAMP, _FRAME = "header.stamp = self.get_clock().now().to_msg()", "header.frame_id = 'map'"
_MAKING = """
    def header(self):
        header = Header()
        {stamp}
        {frame}
        return header
"""
_SENDING = """
def poll(self):
    msg = PointStamped(header={header})
    self.create_publisher(PointStamped, 'at', 10).publish(msg)
"""


@pytest.mark.parametrize(
    ("stamp", "frame", "header", "more", "codes"),
    [
        (_STAMP, _FRAME, "self.header()", "", []),
        ("pass", _FRAME, "self.header()", "", ["RM205"]),
        (_STAMP, "pass", "self.header()", "", ["RM206"]),
        ("pass", "pass", "self.header()", "", ["RM205", "RM206"]),
        ("stamp(header)", "pass", "self.header()", "", []),
        # What is called is another one, or may be.
        ("pass", "pass", "self.header()", "def header(self):\n    return make()", []),
        ("pass", "pass", "self.header()", "def set(self, make):\n    self.header = make", []),
        # The node may fill what its base keeps.
        ("self.kept = header", "pass", "self.header()", "", []),
        ("pass", "pass", "make_header()", "", ["RM205", "RM206"]),
        ("pass", "header = make()", "make_header()", "", []),
    ],
)
def test_a_header_that_another_file_makes(
    stamp: str, frame: str, header: str, more: str, codes: list[str], tmp_path: Path
) -> None:
    made = _MAKING.format(stamp=stamp, frame=frame)
    files = _files(f"{_SENDING.format(header=header)}\n{more}")
    function = dedent(made).replace("header(self)", "make_header(self=None)")
    files["demo/demo/base.py"] += f"{made}\n{function}"
    imports = "from geometry_msgs.msg import PointStamped\nfrom std_msgs.msg import Header\n"
    files["demo/demo/base.py"] = imports + files["demo/demo/base.py"]
    talker = imports + files["demo/demo/talker.py"]
    files["demo/demo/talker.py"] = talker.replace("import Base", "import Base, make_header")
    root = write_tree(tmp_path, files)
    assert [code for code in ("RM205", "RM206") if _told(root, code)] == codes
