#!/usr/bin/env python3
"""The ROS 2 node pilot."""

import sys
import time

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.task import Future
from std_srvs.srv import SetBool, Trigger

SERVICE_TIMEOUT = 10.0
"""How long to wait for a service to be there, and then for its answer, in seconds."""


class PilotNode(Node):
    """Calls services."""

    def __init__(self):
        """Join the ROS graph."""
        super().__init__("pilot")
        self.exit_status = 0
        self.enable_motor_client = self.create_client(SetBool, "enable_motor")
        self.ready_client = self.create_client(Trigger, "ready")

    async def work(self):
        """Do what the node does, one after the other."""
        await self.call_enable_motor()
        await self.call_ready()

    async def call_enable_motor(self):
        """Call enable_motor."""
        await self.call(self.enable_motor_client, SetBool.Request(data=True))

    async def call_ready(self):
        """Call ready."""
        await self.call(self.ready_client, Trigger.Request())

    async def call(self, client, request):
        """Call a service once it is there, and log its answer."""
        deadline = time.monotonic() + SERVICE_TIMEOUT
        while not client.service_is_ready():
            if time.monotonic() > deadline:
                self.fail(f"{client.srv_name}: the service is not there")
                return
            await self.sleep(0.1)
        future = client.call_async(request)
        timer = self.create_timer(SERVICE_TIMEOUT, lambda: future.set_result(None))
        response = await future
        self.destroy_timer(timer)
        if response is None:
            self.fail(f"{client.srv_name}: no answer came in time")
        else:
            self.get_logger().info(f"{client.srv_name}: {response}")

    def fail(self, text):
        """Log an error; the node then ends with status 1."""
        self.get_logger().error(text)
        self.exit_status = 1

    async def sleep(self, seconds):
        """Wait, while the node goes on with its other work."""
        woken = Future()
        timer = self.create_timer(seconds, lambda: woken.set_result(None))
        await woken
        self.destroy_timer(timer)


def main(args=None):
    """Start the node."""
    rclpy.init(args=args)
    try:
        node = PilotNode()
        work = rclpy.get_global_executor().create_task(node.work)
        rclpy.spin_until_future_complete(node, work)
        sys.exit(node.exit_status)
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
