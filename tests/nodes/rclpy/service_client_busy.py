#!/usr/bin/env python3
"""The ROS 2 node captain."""

import time

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.task import Future
from std_msgs.msg import String
from std_srvs.srv import SetBool, Trigger

SERVICE_TIMEOUT = 10.0
"""How long to wait for the answer of a service, in seconds."""

WARNING_PERIOD = 10.0
"""How often to warn that nobody serves what the node waits for, in seconds."""


class CaptainNode(Node):
    """Publishes messages and calls services."""

    def __init__(self):
        """Join the ROS graph."""
        super().__init__("captain")
        self.ready_calls = None
        self.chatter_publisher = self.create_publisher(String, "chatter", 10)
        self.enable_motor_client = self.create_client(SetBool, "enable_motor")
        self.ready_client = self.create_client(Trigger, "ready")
        self.create_timer(1 / 10, self.publish_chatter)
        self.create_timer(1 / 5, self.repeat_ready)

    def publish_chatter(self):
        """Publish to chatter; called at its rate."""
        message = String(data="hello")
        self.chatter_publisher.publish(message)

    async def call_enable_motor(self):
        """Call enable_motor."""
        await self.call(self.enable_motor_client, SetBool.Request(data=True))

    def repeat_ready(self):
        """Call ready; called at its rate, which waits for the last answer."""
        if self.ready_calls is None or self.ready_calls.done():
            self.ready_calls = self.executor.create_task(self.call_ready)

    async def call_ready(self):
        """Call ready."""
        await self.call(self.ready_client, Trigger.Request())

    async def call(self, client, request):
        """Call a service once it is there, and log its answer."""
        await self.wait_until_served(client.srv_name, client.service_is_ready)
        future = client.call_async(request)
        timer = self.create_timer(SERVICE_TIMEOUT, lambda: future.set_result(None))
        response = await future
        self.destroy_timer(timer)
        if response is None:
            self.get_logger().error(f"{client.srv_name}: no answer came in time")
        else:
            self.get_logger().info(f"{client.srv_name}: {response}")

    async def wait_until_served(self, name, is_served):
        """Wait until somebody serves a name, and warn while nobody does."""
        warning_time = time.monotonic() + WARNING_PERIOD
        while not is_served():
            if time.monotonic() > warning_time:
                self.get_logger().warning(f"{name}: nobody serves it yet")
                warning_time += WARNING_PERIOD
            await self.sleep(0.1)

    async def sleep(self, seconds):
        """Wait, while the node goes on with its other work."""
        woken = Future()
        timer = self.create_timer(seconds, lambda: woken.set_result(None))
        await woken
        self.destroy_timer(timer)


def main(args=None):
    """Start the node and keep it running."""
    rclpy.init(args=args)
    try:
        node = CaptainNode()
        rclpy.get_global_executor().create_task(node.call_enable_motor)
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
