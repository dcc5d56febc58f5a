"""Nodes in Python for the tests of rules, and what lint says of a file alone."""

from __future__ import annotations

from pathlib import Path
from textwrap import dedent, indent

from file_sets import one

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.lint.rules import RULES
from plastron_tui.lint.tree import SourceTree, UnitFacts
from plastron_tui.sources.python.facts import code_facts
from plastron_tui.sources.python.reader import read_python

HEAD = """\
import functools
import threading
import time
from functools import partial
from time import sleep

import message_filters
import rclpy
from action_msgs.msg import GoalStatus
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient, ActionServer
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.lifecycle import LifecycleNode
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import Int32, String
from std_srvs.srv import SetBool, Trigger

"""
SPIN = "rclpy.spin(Worker())"


def worker(made: str, methods: str, main: str = SPIN) -> str:
    """Return a node of ROS 2: lines of its constructor, its methods, and what its main does."""
    made, methods, main = (dedent(each).strip("\n") for each in (made, methods, main))
    lines = ["class Worker(Node):", "    def __init__(self):", "        super().__init__('worker')"]
    lines += [indent(made, " " * 8), "", indent(methods, " " * 4), "", ""]
    if main:
        lines += ["def main():", "    rclpy.init()", indent(main, " " * 4), "", ""]
    return HEAD + "\n".join(lines)


def script(text: str) -> str:
    """Return a node of ROS 1."""
    imports = "import actionlib\nimport rospy\nimport time\n"
    imports += "from std_msgs.msg import Empty, Int32, String\n"
    imports += "from std_srvs.srv import SetBool, Trigger\n"
    return f"{imports}from actionlib_tutorials.msg import FibonacciAction\n\n{dedent(text)}"


def diagnostics(text: str, code: str) -> list[Diagnostic]:
    """Return what a rule tells of a program."""
    path = Path("worker.py")
    source = read_python(path, one(text.encode())).source
    assert source is not None
    version = 1 if source.library == "rospy" else 2
    unit = UnitFacts(path, source.library, version, source.nodes, code_facts(source))
    tree = SourceTree(Path(), units=(unit,))
    return list(RULES[code].check(tree))


def told(text: str, code: str) -> list[str]:
    """Return the lines of a program that break a rule; each ends in a comment where it should."""
    found = diagnostics(text, code)
    starts = [each.span.start for each in found if each.span is not None]
    lines = text.splitlines()
    return [lines[text[:start].count("\n")].strip() for start in sorted(starts)]


def marked(text: str) -> list[str]:
    """Return the lines of a program that end in the mark of a mistake."""
    return [line.strip() for line in text.splitlines() if line.rstrip().endswith("# wrong")]
