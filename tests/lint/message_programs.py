"""Nodes that use messages, for the tests of the rules about them, and what lint says of one."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from textwrap import dedent, indent

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.lint.rules import RULES
from plastron_tui.lint.tree import SourceTree, UnitFacts
from plastron_tui.model.source import FileSet
from plastron_tui.ros.catalog import Catalog
from plastron_tui.targets import language_of, read_source, ros_version

_RCLPY = """\
import copy
import json
import math
import time

import message_filters
import rclpy
from builtin_interfaces.msg import Time
from diagnostic_msgs.msg import DiagnosticStatus
from example_interfaces.action import Fibonacci
from geometry_msgs.msg import (
    Point, PointStamped, Pose, PoseArray, PoseStamped, Quaternion, TransformStamped, Twist, Vector3)
from geometry_msgs import msg as geometry
from nav_msgs.msg import Odometry
from rclpy.action import ActionClient, ActionServer
from rclpy.node import Node
from sensor_msgs.msg import JointState, LaserScan
import std_msgs.msg
from std_msgs.msg import Bool, Float32, Float64MultiArray, Header, Int32, String
from std_srvs.srv import SetBool, Trigger, Trigger_Response
from tf2_ros import TransformBroadcaster
from visualization_msgs.msg import Marker

"""

_ROSPY = """\
import actionlib
import rospy
from actionlib_tutorials.msg import FibonacciAction, FibonacciGoal
from geometry_msgs.msg import Point, Pose, PoseStamped, Twist, TwistStamped, Vector3
from nav_msgs.msg import Odometry
from std_msgs.msg import Bool, Empty, Float64, Header, Int32, String
from std_srvs.srv import SetBool, SetBoolRequest, SetBoolResponse, Trigger

"""

_MADE = """\
self.twists = self.create_publisher(Twist, 'cmd_vel', 10)
self.texts = self.create_publisher(String, 'text', 10)
self.scans = self.create_publisher(LaserScan, 'scan', 10)
self.create_subscription(Odometry, 'odom', self.on_odometry, 10)
self.create_subscription(PoseArray, 'poses', self.on_poses, 10)
self.create_subscription(LaserScan, 'scan', lambda msg: self.on_scan(msg, 'front'), 10)
self.set = self.create_service(SetBool, 'set', self.on_set)
self.client = self.create_client(SetBool, 'other')
self.server = ActionServer(self, Fibonacci, 'count', self.on_count)
self.counter = ActionClient(self, Fibonacci, 'count_there')
self.broadcaster = TransformBroadcaster(self)
self.last = Pose()
self.create_timer(1.0, self.tick)
"""


def node(methods: str) -> str:
    """Return a node of ROS 2 with methods; endpoints call some that it may not have."""
    head = ["class Worker(Node):", "    def __init__(self):", "        super().__init__('worker')"]
    parts = [indent(_MADE, " " * 8), indent(dedent(methods).strip("\n"), " " * 4)]
    main = "def main():\n    rclpy.init()\n    rclpy.spin(Worker())\n"
    return _RCLPY + "\n".join((*head, *parts, "", "", main))


def tick(lines: str) -> str:
    """Return a node of ROS 2 whose timer does something."""
    return node("def tick(self):\n" + indent(dedent(lines).strip("\n"), " " * 4))


def script(lines: str) -> str:
    """Return a node of ROS 1."""
    return f"{_ROSPY}rospy.init_node('worker')\n{dedent(lines)}"


@cache
def _catalog(distribution: str) -> Catalog:
    return Catalog(distribution)


def diagnostics(text: str, code: str, suffix: str = ".py") -> list[Diagnostic]:
    """Return what a rule tells of a program."""
    path = Path(f"worker{suffix}")
    source = read_source(path, FileSet.single(suffix, text.encode())).source
    language = language_of(path)
    assert source is not None
    assert language is not None
    version = ros_version(source.library)
    unit = UnitFacts(path, source.library, version, source.nodes, language.code_facts(source))
    catalogs = {1: _catalog("noetic"), 2: _catalog("jazzy")}
    return list(RULES[code].check(SourceTree(Path(), units=(unit,), catalogs=catalogs)))


def told(text: str, code: str, suffix: str = ".py") -> list[str]:
    """Return the lines of a program that break a rule, each once."""
    found = diagnostics(text, code, suffix)
    starts = [each.span.start for each in found if each.span is not None]
    numbers = sorted({text[:start].count("\n") for start in starts})
    return [text.splitlines()[number].strip() for number in numbers]


def marked(text: str) -> list[str]:
    """Return the lines of a program that end in the mark of a mistake."""
    return [line.strip() for line in text.splitlines() if line.rstrip().endswith("# wrong")]


def fixed(text: str, code: str) -> str:
    """Return a program with the fixes of a rule applied."""
    edits = [edit for each in diagnostics(text, code) if each.fix for edit in each.fix.edits]
    for edit in sorted(edits, key=lambda each: each.span, reverse=True):
        text = text[: edit.span.start] + edit.text + text[edit.span.end :]
    return text
