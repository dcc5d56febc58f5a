#!/usr/bin/env python3
"""The ROS 2 node talker."""

import time

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Int32, String
from std_srvs.srv import Empty

SERVICE_TIMEOUT = 10.0
"""How long to wait for a service to be there, and then for its answer, in seconds."""


class TalkerNode(Node):
    """Publishes messages and calls services."""

    def __init__(self):
        """Join the ROS graph."""
        super().__init__("talker")
        self.own = self.create_publisher(String, "own", 10)  # by hand
        self.chatter_publisher = self.create_publisher(String, "chatter", 10)
        self.count_publisher = self.create_publisher(Int32, "count", 10)
        self.reset_client = self.create_client(Empty, "reset")
        self.create_timer(1 / 2, self.publish_chatter)
        self.create_timer(1 / 10, self.publish_count)

    def publish_chatter(self):
        """Publish to chatter; called at its rate."""
        message = String(data="hello")
        self.chatter_publisher.publish(message)

    def publish_count(self):
        """Publish to count; called at its rate."""
        message = Int32(data=5)
        self.count_publisher.publish(message)

    def call_services(self):
        """Call each service in turn."""
        self.call(self.reset_client, Empty.Request())

    def call(self, client, request):
        """Call a service once it is there, and log its answer.

        The node goes on with its other work while it waits.
        """
        deadline = time.monotonic() + SERVICE_TIMEOUT
        while not client.service_is_ready():
            if time.monotonic() > deadline:
                self.get_logger().error(f"{client.srv_name}: the service is not there")
                return
            rclpy.spin_once(self, timeout_sec=0.1)
        future = client.call_async(request)
        rclpy.spin_until_future_complete(self, future, timeout_sec=SERVICE_TIMEOUT)
        if future.done():
            self.get_logger().info(f"{client.srv_name}: {future.result()}")
        else:
            client.remove_pending_request(future)
            self.get_logger().error(f"{client.srv_name}: no answer came in time")


def main(args=None):
    """Start the node and keep it running."""
    rclpy.init(args=args)
    try:
        node = TalkerNode()
        node.call_services()
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
