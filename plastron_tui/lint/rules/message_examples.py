"""The nodes of the examples of the rules about messages."""

from __future__ import annotations

_DRIVER = """\
import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.pub = self.create_publisher(Twist, 'cmd_vel', 10)
        self.create_timer(0.1, self.drive)

    def drive(self):
        msg = Twist()
        msg.{field} = {value}
        self.pub.publish(msg)


def main():
    rclpy.init()
    rclpy.spin(Driver())
"""

_SENDER = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Sender(Node):
    def __init__(self):
        super().__init__('sender')
        self.pub = self.create_publisher(String, 'greeting', 10)
        self.create_timer(1.0, self.send)

    def send(self):
        self.pub.publish({construct})


def main():
    rclpy.init()
    rclpy.spin(Sender())
"""

_SCANNER = """\
import rclpy
from rclpy.node import Node
from sensor_msgs.msg import LaserScan


class Scanner(Node):
    def __init__(self):
        super().__init__('scanner')
        self.pub = self.create_publisher(LaserScan, 'scan', 10)
        self.create_timer(0.1, self.scan)

    def scan(self):
        msg = LaserScan()
{header}        msg.ranges = [1.0, 2.0]
        self.pub.publish(msg)


def main():
    rclpy.init()
    rclpy.spin(Scanner())
"""

_STAMP = "        msg.header.stamp = self.get_clock().now().to_msg()\n"
_FRAME = "        msg.header.frame_id = 'laser'\n"


def driver(field: str = "linear.x", value: str = "1.0") -> str:
    """Return a node that drives a robot."""
    return _DRIVER.format(field=field, value=value)


def sender(value: str = "'hello'", construct: str = "") -> str:
    """Return a node that sends a text."""
    return _SENDER.format(construct=construct or f"String(data={value})")


def scanner(*, has_stamp: bool = True, has_frame: bool = True) -> str:
    """Return a node that sends what a laser sees."""
    header = _STAMP * has_stamp + _FRAME * has_frame
    return _SCANNER.format(header=header)
