#!/usr/bin/env python3
"""The ROS 2 node listener."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Int32, String
from std_srvs.srv import Empty


class ListenerNode(Node):
    """Listens to messages and provides services."""

    def __init__(self):
        """Join the ROS graph."""
        super().__init__("listener")
        self.create_service(Empty, "reset", self.handle_reset)
        self.create_service(Empty, "stop", self.handle_stop)
        self.create_subscription(String, "chatter", self.on_chatter, 10)
        self.create_subscription(Int32, "count", self.on_count, 10)

    def on_chatter(self, message):
        """Handle a message from chatter."""
        self.heard = 1  # by hand
        self.get_logger().info(f"chatter: {message}")

    def on_count(self, message):
        """Handle a message from count."""
        self.get_logger().info(f"count: {message}")

    def handle_reset(self, request, response):
        """Answer a request to reset."""
        self.resets = 1  # by hand
        self.get_logger().info(f"reset: {request}")
        return response

    def handle_stop(self, request, response):
        """Answer a request to stop."""
        self.get_logger().info(f"stop: {request}")
        return response


def main(args=None):
    """Start the node and keep it running."""
    rclpy.init(args=args)
    try:
        node = ListenerNode()
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    except Exception:
        # Ctrl-C ends ROS at once: what fails after that is no mistake.
        if rclpy.ok():
            raise
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        pass
