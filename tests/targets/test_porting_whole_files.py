"""Whole nodes brought from one ROS to the other, before → after."""

from __future__ import annotations

import subprocess
import sys

import pytest
from ported_nodes import LISTENER_1, LISTENER_2, OTHER, SPIN, endpoints, ported, source

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
SERVER_2 = f"""\
import traceback

import rclpy
from rclpy.executors import ExternalShutdownException
from example_interfaces.srv import AddTwoInts
from geometry_msgs.msg import PointStamped

AddTwoIntsResponse = AddTwoInts.Response


{SPIN}

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
        point.header.stamp = node.get_clock().now().to_msg()
        if point.header.stamp.sec > 5:
            self.points.publish(point)


if __name__ == "__main__":
    rclpy.init()
    node = rclpy.create_node("adder")
    Adder()
    spin()
"""
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
from std_msgs.msg import String
from std_srvs.srv import SetBool, SetBoolResponse


class Robot:
    """A robot."""

    def __init__(self):
        rospy.init_node("robot")
        self.publisher = rospy.Publisher("chatter", String, queue_size=10)
        rospy.Subscriber("orders", String, self.on_order, queue_size=5)
        rospy.Service("~power", SetBool, self.on_power)
        rospy.Timer(rospy.Duration(0.5), self.tick)

    def on_order(self, message):
        rospy.loginfo(message.data)

    def on_power(self, request):
        """Switch it."""
        response = SetBoolResponse()
        response.success = request.data
        return response

    def tick(self, event=None):
        self.publisher.publish(String(data="hello"))


def main(args=None):
    Robot()
    try:
        rospy.spin()
    except (KeyboardInterrupt, rospy.ROSInterruptException):
        pass
'''
WHOLE = {
    "rospy listener": ("rospy", LISTENER_1, LISTENER_2),
    "rospy server": ("rospy", SERVER_1, SERVER_2),
    "rclpy robot": ("rclpy", ROBOT_2, ROBOT_1),
}


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


def test_there_and_back_shows_the_same_endpoints() -> None:
    for library, before, _ in WHOLE.values():
        there, _ = ported(before, library)
        back, _ = ported(there, OTHER[library])
        assert endpoints(source(back, library)) == endpoints(source(before, library))
