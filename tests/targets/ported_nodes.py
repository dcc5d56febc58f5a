"""What the tests of porting share: a node in both libraries, and the way from one to the other."""

from __future__ import annotations

import ast
from collections import Counter
from pathlib import Path

from file_sets import one

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.model.kinds import EDITABLE
from plastron_tui.model.source import EndpointKind, SourceUnit
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.sources.python import read_python
from plastron_tui.targets import find_target

CATALOGS = {"rospy": Catalog("noetic"), "rclpy": Catalog("kilted")}
OTHER = {"rospy": "rclpy", "rclpy": "rospy"}
PORTED = tuple(
    kind
    for kind in EDITABLE
    if kind.facts.interface in (InterfaceKind.MESSAGE, InterfaceKind.SERVICE)
)
"""The kinds of endpoints that are carried over; of the others it is told what is to be done."""
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
HEAD = """\
import rospy
import std_msgs.msg
from geometry_msgs.msg import Point, PointStamped, Twist
from std_msgs.msg import Bool, Byte, Float32MultiArray, Float64, Header, Int32, String
from std_srvs.srv import Empty, SetBool, Trigger, TriggerResponse
from rospy_tutorials.srv import AddTwoInts, AddTwoIntsRequest, AddTwoIntsResponse

rospy.init_node('n')
text = rospy.Publisher('text', String, queue_size=1)
number = rospy.Publisher('number', Float64, queue_size=1)
whole = rospy.Publisher('whole', Int32, queue_size=1)
flag = rospy.Publisher('flag', Bool, queue_size=1)
octet = rospy.Publisher('octet', Byte, queue_size=1)
point = rospy.Publisher('point', Point, queue_size=1)
stamped = rospy.Publisher('stamped', PointStamped, queue_size=1)
numbers = rospy.Publisher('numbers', Float32MultiArray, queue_size=1)
dotted = rospy.Publisher('dotted', std_msgs.msg.String, queue_size=1)
"""
SPIN = '''\
def spin():
    """Handle what comes until ROS ends; log what a callback raises."""
    while rclpy.ok():
        try:
            rclpy.spin(node)
        except (KeyboardInterrupt, ExternalShutdownException):
            break
        except Exception:
            if rclpy.ok():
                node.get_logger().error(traceback.format_exc())
'''
LISTENER_2 = f'''\
#!/usr/bin/env python3
"""Hears things."""

import os
import traceback

import rclpy
from rclpy.executors import ExternalShutdownException
from std_msgs.msg import String

node = None


{SPIN}

LOUD = "!"


def shout(text):
    return text.upper() + LOUD


def callback(data):
    text = shout(data.data)
    node.get_logger().info((node.get_fully_qualified_name() + "I heard %s") % (text,))


def listener():
    global node
    rclpy.init()
    node = rclpy.create_node(f"listener_{{os.getpid()}}")
    node.create_subscription(String, "chatter", callback, 10)
    # spin() simply keeps python from exiting
    spin()


if __name__ == "__main__":
    listener()
'''


def source(text: str | bytes, library: str) -> SourceUnit:
    data = text.encode() if isinstance(text, str) else text
    found = read_python(Path("node.py"), one(data), library).source
    assert found is not None
    return found


def ported(text: str | bytes, library: str) -> tuple[str, tuple[Diagnostic, ...]]:
    """Bring a file to the other client library."""
    target = find_target(OTHER[library])
    assert target is not None
    read = source(text, library)
    result = target.port(None, read, CATALOGS[OTHER[library]])  # type: ignore[arg-type]
    assert result.files is not None, result.diagnostics
    return result.files.main.decode("utf-8", "replace"), result.diagnostics


def count_marks(text: str) -> int:
    """Return how many comments there are, beside the one of an import that a marked line needs."""
    return text.count(MARK) - text.count(f"{MARK}import ")


def endpoints(read: SourceUnit) -> Counter[tuple[EndpointKind, str]]:
    return Counter(
        (each.kind, each.name.replace("~/", "~"))
        for each in read.endpoints
        if each.kind in PORTED and each.name is not None
    )


def after_head(before: str) -> str:
    text, _ = ported(HEAD + before + "\n", "rospy")
    ast.parse(text)
    return text
