"""Nodes that this file does not make: all it has is a name, an annotation or what they create."""
from typing import Any, Optional

import rclpy
from rclpy.node import Node
from std_msgs.msg import Int8, String
from robot_base import BaseNode, Client, make_node
from robot_types import ODOMETRY, Reset

base = BaseNode('base')
base.create_publisher(String, 'from_class', 10)
made = make_node()
made.create_publisher(String, 'from_function', 10)
api = Client()
api.create_publisher(ODOMETRY, 'not_a_node', 10)


def watch(node: Any, late: "rclpy.node.Node", other: Optional[Node] = None):
    node.create_subscription(ODOMETRY, 'untyped', print, 10)
    node.declare_parameter('depth', 5)
    late.create_publisher(Int8, 'late', 1)
    other.create_publisher(Int8, 'other', 1)


class Panel:
    def __init__(self, robot, node, options):
        self.node = node
        self._robot = robot
        self.reset = self.node.create_client(Reset, 'reset')
        self._robot.create_publisher(Int8, 'panel', 1)
        self.node.create_subscription(**options, callback=self.show)
        self._robot.create_publisher('panel', 'no_type', 1)
        robot.nodes[0].create_publisher(Int8, 'first', 1)

    def show(self, message):
        print(message)


def current() -> Node:
    return base


current().create_publisher(Int8, 'returned', 1)
