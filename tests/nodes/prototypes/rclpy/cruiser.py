#!/usr/bin/env python3
"""The ROS 2 node cruiser."""

import rclpy
from geometry_msgs.msg import Twist, TwistStamped, Vector3
from rcl_interfaces.msg import (
    FloatingPointRange,
    IntegerRange,
    ParameterDescriptor,
    SetParametersResult,
)
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Bool, Float64MultiArray, Header, Int32, Int32MultiArray


class CruiserNode(Node):
    """Publishes messages and repeats functions."""

    def __init__(self):
        """Join the ROS graph."""
        super().__init__("cruiser")
        self.declare_parameter(
            "speed",
            0.5,
            ParameterDescriptor(
                description="Used in messages to cmd_vel.",
                floating_point_range=[FloatingPointRange(from_value=0.0, to_value=1.0)],
            ),
        )
        self.declare_parameter(
            "gear",
            1,
            ParameterDescriptor(
                description="Used in messages to gear.",
                integer_range=[IntegerRange(from_value=-1, to_value=5)],
            ),
        )
        self.declare_parameter(
            "rate",
            10.0,
            ParameterDescriptor(
                description="Rate of cmd_vel, in Hz.",
                floating_point_range=[FloatingPointRange(from_value=0.001, to_value=1000.0)],
            ),
        )
        self.declare_parameter("is_on", True)
        self.declare_parameter("frame", "map")
        self.declare_parameter("gains", [1.0, 0.5])
        self.declare_parameter("ports", [80, 443])
        self.cmd_vel_publisher = self.create_publisher(TwistStamped, "cmd_vel", 10)
        self.gear_publisher = self.create_publisher(Int32, "gear", 10)
        self.power_publisher = self.create_publisher(Bool, "power", 10)
        self.gains_publisher = self.create_publisher(Float64MultiArray, "gains", 10)
        self.ports_publisher = self.create_publisher(Int32MultiArray, "ports", 10)
        self.cmd_vel_timer = self.create_timer(
            1 / self.get_parameter("rate").value, self.publish_cmd_vel
        )
        self.create_timer(1 / 20, self.publish_gear)
        self.create_timer(1 / 20, self.publish_power)
        self.create_timer(1 / 20, self.publish_gains)
        self.create_timer(1 / 20, self.publish_ports)
        self.create_timer(1 / 4, self.look_around)
        self.add_on_set_parameters_callback(self.follow_rates)

    def follow_rates(self, parameters):
        """Let the timers follow the rates; what is out of range has been refused before."""
        for parameter in parameters:
            if parameter.name == "rate":
                self.cmd_vel_timer.timer_period_ns = int(1e9 / parameter.value)
                self.cmd_vel_timer.reset()
        return SetParametersResult(successful=True)

    def publish_cmd_vel(self):
        """Publish to cmd_vel; called at its rate."""
        message = TwistStamped(
            header=Header(frame_id=self.get_parameter("frame").value),
            twist=Twist(linear=Vector3(x=self.get_parameter("speed").value)),
        )
        message.header.stamp = self.get_clock().now().to_msg()
        self.cmd_vel_publisher.publish(message)

    def publish_gear(self):
        """Publish to gear; called at its rate."""
        message = Int32(data=self.get_parameter("gear").value)
        self.gear_publisher.publish(message)

    def publish_power(self):
        """Publish to power; called at its rate."""
        message = Bool(data=self.get_parameter("is_on").value)
        self.power_publisher.publish(message)

    def publish_gains(self):
        """Publish to gains; called at its rate."""
        message = Float64MultiArray(data=list(self.get_parameter("gains").value))
        self.gains_publisher.publish(message)

    def publish_ports(self):
        """Publish to ports; called at its rate."""
        message = Int32MultiArray(data=list(self.get_parameter("ports").value))
        self.ports_publisher.publish(message)

    def look_around(self):
        """Do what is to be done again and again; called at its rate."""
        self.get_logger().info("look_around", throttle_duration_sec=1.0)


def main(args=None):
    """Start the node and keep it running."""
    rclpy.init(args=args)
    try:
        node = CruiserNode()
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
