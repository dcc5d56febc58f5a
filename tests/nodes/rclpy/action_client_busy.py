#!/usr/bin/env python3
"""The ROS 2 node driver."""

import time

import rclpy
from action_msgs.msg import GoalStatus
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.task import Future
from std_msgs.msg import String

WARNING_PERIOD = 10.0
"""How often to warn that nobody serves what the node waits for, in seconds."""


class DriverNode(Node):
    """Publishes messages and sends goals."""

    def __init__(self):
        """Join the ROS graph."""
        super().__init__("driver")
        self.chatter_publisher = self.create_publisher(String, "chatter", 10)
        self.count_client = ActionClient(self, Fibonacci, "count")
        self.create_timer(1 / 10, self.publish_chatter)

    def publish_chatter(self):
        """Publish to chatter; called at its rate."""
        message = String(data="hello")
        self.chatter_publisher.publish(message)

    async def send_count(self):
        """Send the goals of count, one after the other."""
        await self.send_goal("count", self.count_client, Fibonacci.Goal(order=5))

    async def send_goal(self, name, client, goal):
        """Send a goal once its action is served, and log its feedback and its result.

        Ctrl-C ends the node, and leaves the goal to the server.
        """
        await self.wait_until_served(name, client.server_is_ready)
        sent = client.send_goal_async(
            goal, lambda message: self.get_logger().info(f"{name}: {message.feedback}")
        )
        goal_handle = await self.answer(client, sent)
        if goal_handle is None:
            self.get_logger().error(f"{name}: the server is gone")
            return
        if not goal_handle.accepted:
            self.get_logger().error(f"{name}: the goal was rejected")
            return
        response = await self.answer(client, goal_handle.get_result_async())
        if response is None:
            self.get_logger().error(f"{name}: the server is gone")
        elif response.status == GoalStatus.STATUS_SUCCEEDED:
            self.get_logger().info(f"{name}: succeeded: {response.result}")
        elif response.status == GoalStatus.STATUS_CANCELED:
            self.get_logger().error(f"{name}: canceled: {response.result}")
        else:
            self.get_logger().error(f"{name}: aborted: {response.result}")

    async def answer(self, client, future):
        """Return what an action server answers, or None if the server is gone."""
        while not future.done() and client.server_is_ready():
            await self.sleep(0.1)
        return future.result()

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
        node = DriverNode()
        rclpy.get_global_executor().create_task(node.send_count)
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
