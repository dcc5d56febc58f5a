#!/usr/bin/env python3
"""The ROS 2 node reflex."""

import rclpy
from geometry_msgs.msg import PointStamped, Twist, Vector3
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from sensor_msgs.msg import Joy, LaserScan
from std_msgs.msg import Float64, Header, UInt8
from std_srvs.srv import SetBool


def whole(number, least, most):
    """Return the nearest integer, or raise a ValueError where a field cannot hold it."""
    if not least <= round(number) <= most:
        raise ValueError(f"{number} is not from {least} to {most}")
    return round(number)


class ReflexNode(Node):
    """Publishes messages, listens to messages and provides services."""

    def __init__(self):
        """Join the ROS graph."""
        super().__init__("reflex")
        self.stop_publisher = self.create_publisher(Twist, "stop", 10)
        self.clear_publisher = self.create_publisher(Twist, "clear", 10)
        self.cmd_vel_publisher = self.create_publisher(Twist, "cmd_vel", 10)
        self.gear_publisher = self.create_publisher(UInt8, "gear", 10)
        self.half_publisher = self.create_publisher(PointStamped, "half", 10)
        self.create_service(SetBool, "switch", self.handle_switch)
        self.create_subscription(LaserScan, "scan", self.on_scan, 10)
        self.create_subscription(Joy, "joy", self.on_joy, 10)
        self.create_subscription(Float64, "level", self.on_level, 10)

    def publish_stop(self, received):
        """Publish to stop; called for each message from scan."""
        if any(each < 0.5 for each in received.ranges):
            message = Twist()
            self.stop_publisher.publish(message)

    def publish_clear(self, received):
        """Publish to clear; called for each message from scan."""
        if all(each > 2.0 for each in received.ranges):
            message = Twist(linear=Vector3(x=1.0))
            self.clear_publisher.publish(message)

    def publish_cmd_vel(self, received):
        """Publish to cmd_vel; called for each message from joy."""
        try:
            message = Twist(
                linear=Vector3(x=received.axes[1] * 0.5), angular=Vector3(z=received.axes[0] / 2)
            )
            self.cmd_vel_publisher.publish(message)
        except (ArithmeticError, IndexError, ValueError) as error:
            self.get_logger().warning(f"cmd_vel: {error}", throttle_duration_sec=5.0)

    def publish_gear(self, received):
        """Publish to gear; called for each message from level."""
        try:
            message = UInt8(data=whole(received.data * 10, 0, 255))
            self.gear_publisher.publish(message)
        except (ArithmeticError, IndexError, ValueError) as error:
            self.get_logger().warning(f"gear: {error}", throttle_duration_sec=5.0)

    def publish_half(self, received):
        """Publish to half; called for each message from joy."""
        try:
            if received.buttons[0] == 1:
                message = PointStamped(header=Header(frame_id=received.header.frame_id))
                message.header.stamp = self.get_clock().now().to_msg()
                self.half_publisher.publish(message)
        except (ArithmeticError, IndexError, ValueError) as error:
            self.get_logger().warning(f"half: {error}", throttle_duration_sec=5.0)

    def on_scan(self, message):
        """Handle a message from scan."""
        self.publish_stop(message)
        self.publish_clear(message)

    def on_joy(self, message):
        """Handle a message from joy."""
        self.publish_cmd_vel(message)
        self.publish_half(message)

    def on_level(self, message):
        """Handle a message from level."""
        self.publish_gear(message)

    def handle_switch(self, request, response):
        """Answer a request to switch."""
        return SetBool.Response(success=request.data, message="switched")


def main(args=None):
    """Start the node and keep it running."""
    rclpy.init(args=args)
    try:
        node = ReflexNode()
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
