"""The clock of a simulation that has begun: seconds go by as the tests' own do."""

from contextlib import suppress

import rclpy
from rclpy.executors import ExternalShutdownException
from rosgraph_msgs.msg import Clock


def main():
    rclpy.init()
    node = rclpy.create_node("simulation")
    publisher = node.create_publisher(Clock, "/clock", 10)
    start = node.get_clock().now()

    def tick():
        passed = (node.get_clock().now() - start).nanoseconds
        message = Clock()
        message.clock.sec, message.clock.nanosec = divmod(passed, 10**9)
        publisher.publish(message)

    node.create_timer(0.01, tick)
    with suppress(KeyboardInterrupt, ExternalShutdownException):
        rclpy.spin(node)


if __name__ == "__main__":
    main()
