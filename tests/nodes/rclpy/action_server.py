#!/usr/bin/env python3
"""The ROS 2 node calculator."""

import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionServer, CancelResponse
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.task import Future
from std_msgs.msg import String


class CalculatorNode(Node):
    """Publishes messages and provides actions."""

    def __init__(self):
        """Join the ROS graph."""
        super().__init__("calculator")
        self.count_goal = None
        self.chatter_publisher = self.create_publisher(String, "chatter", 10)
        ActionServer(
            self,
            Fibonacci,
            "count",
            self.execute_count,
            cancel_callback=self.accept_cancel,
        )
        self.create_timer(1 / 10, self.publish_chatter)

    def publish_chatter(self):
        """Publish to chatter; called at its rate."""
        message = String(data="hello")
        self.chatter_publisher.publish(message)

    async def execute_count(self, goal_handle):
        """Work on a goal of count; a cancel ends it early, and so does a new goal.

        What waits with `await self.sleep(...)` leaves the node free for its other work.
        """
        self.get_logger().info(f"count: {goal_handle.request}")
        self.count_goal = goal_handle
        for _ in range(10):
            if goal_handle.is_cancel_requested:
                goal_handle.canceled()
                return Fibonacci.Result()
            if self.count_goal is not goal_handle:
                goal_handle.abort()
                return Fibonacci.Result()
            # The work of one step goes here.
            goal_handle.publish_feedback(Fibonacci.Feedback())
            await self.sleep(0.5)
        goal_handle.succeed()
        return Fibonacci.Result()

    def accept_cancel(self, goal_handle):
        """Let whoever sent a goal cancel it; rclpy would not."""
        return CancelResponse.ACCEPT

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
        node = CalculatorNode()
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
