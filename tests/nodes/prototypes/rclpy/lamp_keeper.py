#!/usr/bin/env python3
"""The ROS 2 node lamp_keeper."""

import rclpy
from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor, SetParametersResult
from rclpy.executors import ExternalShutdownException
from rclpy.lifecycle import LifecycleNode
from std_msgs.msg import Bool, Int32, String
from std_srvs.srv import SetBool


class LampKeeperNode(LifecycleNode):
    """Publishes messages, listens to messages, provides services and repeats functions.

    What it has is there from configuration to cleanup; it publishes while it is active.
    """

    def __init__(self):
        """Join the ROS graph."""
        super().__init__("lamp_keeper")
        self.declare_parameter(
            "rate",
            20.0,
            ParameterDescriptor(
                description="Rate of count, in Hz.",
                floating_point_range=[FloatingPointRange(from_value=0.001, to_value=1000.0)],
            ),
        )
        self.state_publisher = None
        self.count_publisher = None
        self.set_lamp_client = None
        self.switch_service = None
        self.mood_subscription = None
        self.state_timer = None
        self.count_timer = None
        self.look_around_timer = None
        self.add_on_set_parameters_callback(self.follow_rates)

    def on_configure(self, state):
        """Create publishers, clients, services and subscriptions."""
        self.state_publisher = self.create_lifecycle_publisher(Bool, "state", 10)
        self.count_publisher = self.create_lifecycle_publisher(Int32, "count", 10)
        self.set_lamp_client = self.create_client(SetBool, "set_lamp")
        self.switch_service = self.create_service(SetBool, "switch", self.handle_switch)
        self.mood_subscription = self.create_subscription(String, "mood", self.on_mood, 10)
        return super().on_configure(state)

    def on_activate(self, state):
        """Create the timers."""
        self.state_timer = self.create_timer(1 / 10, self.publish_state)
        self.count_timer = self.create_timer(
            1 / self.get_parameter("rate").value, self.publish_count
        )
        self.look_around_timer = self.create_timer(1 / 4, self.look_around)
        return super().on_activate(state)

    def on_deactivate(self, state):
        """Destroy the timers."""
        self.destroy_timers()
        return super().on_deactivate(state)

    def on_cleanup(self, state):
        """Destroy what was created at configuration."""
        self.destroy_endpoints()
        return super().on_cleanup(state)

    def on_shutdown(self, state):
        """Destroy all that there is."""
        self.destroy_timers()
        self.destroy_endpoints()
        return super().on_shutdown(state)

    def on_error(self, state):
        """Destroy all that there is, so that the node can be configured again."""
        self.destroy_timers()
        self.destroy_endpoints()
        return super().on_error(state)

    def destroy_timers(self):
        """Destroy the timers that are there."""
        self.destroy_timer(self.state_timer)
        self.destroy_timer(self.count_timer)
        self.destroy_timer(self.look_around_timer)

    def destroy_endpoints(self):
        """Destroy the publishers, clients, services and subscriptions that are there."""
        self.destroy_lifecycle_publisher(self.state_publisher)
        self.destroy_lifecycle_publisher(self.count_publisher)
        self.destroy_client(self.set_lamp_client)
        self.destroy_service(self.switch_service)
        self.destroy_subscription(self.mood_subscription)

    def follow_rates(self, parameters):
        """Let the timers follow the rates; what is out of range has been refused before."""
        for parameter in parameters:
            if parameter.name == "rate" and self.count_timer in self.timers:
                self.count_timer.timer_period_ns = int(1e9 / parameter.value)
                self.count_timer.reset()
        return SetParametersResult(successful=True)

    def publish_state(self):
        """Publish to state; called at its rate."""
        message = Bool(data=True)
        self.state_publisher.publish(message)

    def publish_count(self):
        """Publish to count; called at its rate."""
        message = Int32(data=1)
        self.count_publisher.publish(message)

    def look_around(self):
        """Do what is to be done again and again; called at its rate."""
        self.get_logger().info("look_around", throttle_duration_sec=1.0)

    def on_mood(self, message):
        """Handle a message from mood."""
        self.get_logger().info(f"mood: {message}")

    def handle_switch(self, request, response):
        """Answer a request to switch."""
        self.get_logger().info(f"switch: {request}")
        return response


def main(args=None):
    """Start the node and keep it running."""
    rclpy.init(args=args)
    try:
        node = LampKeeperNode()
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
