"""One node that goes by many names."""
from __future__ import annotations

import rclpy
from rclpy.node import Node
from std_msgs.msg import Int8, String
from std_srvs.srv import Empty


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        me = self
        me.pub = me.create_publisher(Int8, 'a', 1)
        outer = self

        class Part:
            def attach(self):
                self.pub = outer.create_publisher(Int8, 'b', 1)

        self.part = Part()
        self.parts = [Wheel(self), Lamp(robot=self)]


class Wheel:
    def __init__(self, robot):
        self.robot = robot
        self.sub = robot.create_subscription(Int8, 'c', self.turn, 1)

    def turn(self, msg):
        self.pub = self.robot.create_publisher(Int8, 'd', 1)


class Lamp:
    def __init__(self, robot: Robot):
        self._client = robot.create_client(Empty, 'e')


def annotated(one: Node, other: 'Robot'):
    one.create_publisher(String, 'f', 1)
    other.create_publisher(String, 'g', 1)
    other.create_timer(1.0, print)


def main():
    rclpy.init()
    robot = Robot()
    for each in [robot]:
        each.create_publisher(String, 'h', 1)
    annotated(robot, robot)
    Robot().create_publisher(String, 'i', 1)
    rclpy.spin(robot)
