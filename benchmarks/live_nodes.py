"""A node of rclpy with 200 topics, each with five messages a second: 1,000 in all."""

from __future__ import annotations

import contextlib

import rclpy
from geometry_msgs.msg import Twist
from rclpy._rclpy_pybind11 import RCLError
from rclpy.executors import ExternalShutdownException
from rclpy.signals import SignalHandlerOptions
from std_msgs.msg import Float64, String

TOPICS = 200
HERTZ = 5.0
_GROUPS = 20


def main() -> None:
    rclpy.init(signal_handler_options=SignalHandlerOptions.ALL)
    node = rclpy.create_node("many")
    kinds = (Float64, String, Twist)
    made = [
        (node.create_publisher(kinds[at % 3], f"topic_{at:03}", 10), kinds[at % 3])
        for at in range(TOPICS)
    ]
    turn = 0

    def tick() -> None:
        """Send a group of the topics: the messages are spread over the time."""
        nonlocal turn
        turn += 1
        for publisher, kind in made[turn % _GROUPS :: _GROUPS]:
            message = kind()
            if kind is Float64:
                message.data = float(turn % 100)
            elif kind is String:
                message.data = f"message {turn}"
            else:
                message.linear.x = float(turn % 100)
            publisher.publish(message)

    node.create_timer(1 / HERTZ / _GROUPS, tick)
    # What it is stopped by may come while it waits, or while it prepares to.
    with contextlib.suppress(KeyboardInterrupt, ExternalShutdownException, RCLError):
        rclpy.spin(node)


if __name__ == "__main__":
    main()
