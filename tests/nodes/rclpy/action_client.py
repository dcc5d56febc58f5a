#!/usr/bin/env python3
"""The ROS 2 node asker."""

import sys
import time

import rclpy
from action_msgs.msg import GoalStatus
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.task import Future

WARNING_PERIOD = 10.0
"""How often to warn that nobody serves what the node waits for, in seconds."""


class AskerNode(Node):
    """Sends goals."""

    def __init__(self):
        """Join the ROS graph."""
        super().__init__("asker")
        self.exit_status = 0
        self.count_client = ActionClient(self, Fibonacci, "count")

    async def work(self):
        """Do what the node does, one after the other."""
        await self.send_count()

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
            self.fail(f"{name}: the server is gone")
            return
        if not goal_handle.accepted:
            self.fail(f"{name}: the goal was rejected")
            return
        response = await self.answer(client, goal_handle.get_result_async())
        if response is None:
            self.fail(f"{name}: the server is gone")
        elif response.status == GoalStatus.STATUS_SUCCEEDED:
            self.get_logger().info(f"{name}: succeeded: {response.result}")
        elif response.status == GoalStatus.STATUS_CANCELED:
            self.fail(f"{name}: canceled: {response.result}")
        else:
            self.fail(f"{name}: aborted: {response.result}")

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
        node = AskerNode()
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
