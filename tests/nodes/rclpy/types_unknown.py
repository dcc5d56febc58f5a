import importlib

import rclpy
from rclpy.node import Node
from rosidl_runtime_py.utilities import get_message
from std_msgs.msg import String

from .interfaces import Local
from robot.messages import Wrapped

try:
    from new_interfaces.msg import Status
except ImportError:
    from old_interfaces.msg import Status


class Envelope:
    pass


class TypesUnknown(Node):
    def __init__(self, kind):
        super().__init__('types_unknown')
        self.create_subscription(kind, 'a', self.heard, 1)
        self.create_subscription(Status, 'b', self.heard, 1)
        self.create_subscription(Envelope, 'c', self.heard, 1)
        self.create_subscription(Wrapped, 'd', self.heard, 1)
        self.create_subscription(Local, 'e', self.heard, 1)
        self.create_subscription(getattr(importlib.import_module('std_msgs.msg'), 'String'), 'f', self.heard, 1)
        for topic, kind in self.get_topic_names_and_types():
            self.create_subscription(get_message(kind[0]), topic, self.heard, 1)

    def heard(self, msg):
        pass


rclpy.init()
rclpy.spin(TypesUnknown(String))
