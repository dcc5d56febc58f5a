#!/usr/bin/env python3
"""The ROS 2 node qualities."""

import rclpy
from rclpy.duration import Duration
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import (
    DurabilityPolicy,
    HistoryPolicy,
    LivelinessPolicy,
    QoSProfile,
    ReliabilityPolicy,
    qos_profile_sensor_data,
    qos_profile_system_default,
)
from std_msgs.msg import Int32, String


class QualitiesNode(Node):
    """Publishes messages and listens to messages."""

    def __init__(self):
        """Join the ROS graph."""
        super().__init__("qualities")
        self.scan_publisher = self.create_publisher(Int32, "scan", qos_profile_sensor_data)
        self.usual_publisher = self.create_publisher(Int32, "usual", qos_profile_system_default)
        self.map_publisher = self.create_publisher(
            Int32, "map", QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        )
        self.image_publisher = self.create_publisher(
            Int32, "image", QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)
        )
        self.log_publisher = self.create_publisher(
            Int32, "log", QoSProfile(history=HistoryPolicy.KEEP_ALL)
        )
        self.pulse_publisher = self.create_publisher(
            Int32,
            "pulse",
            QoSProfile(
                depth=10,
                deadline=Duration(seconds=0.5),
                lifespan=Duration(seconds=2),
                liveliness=LivelinessPolicy.MANUAL_BY_TOPIC,
                liveliness_lease_duration=Duration(seconds=1),
            ),
        )
        self.create_subscription(String, "words", self.on_words, qos_profile_sensor_data)
        self.create_timer(1 / 20, self.publish_scan)
        self.create_timer(1 / 20, self.publish_usual)
        self.create_timer(1 / 20, self.publish_map)
        self.create_timer(1 / 20, self.publish_image)
        self.create_timer(1 / 20, self.publish_log)
        self.create_timer(1 / 20, self.publish_pulse)

    def publish_scan(self):
        """Publish to scan; called at its rate."""
        message = Int32(data=1)
        self.scan_publisher.publish(message)

    def publish_usual(self):
        """Publish to usual; called at its rate."""
        message = Int32(data=2)
        self.usual_publisher.publish(message)

    def publish_map(self):
        """Publish to map; called at its rate."""
        message = Int32(data=3)
        self.map_publisher.publish(message)

    def publish_image(self):
        """Publish to image; called at its rate."""
        message = Int32(data=4)
        self.image_publisher.publish(message)

    def publish_log(self):
        """Publish to log; called at its rate."""
        message = Int32(data=5)
        self.log_publisher.publish(message)

    def publish_pulse(self):
        """Publish to pulse; called at its rate."""
        message = Int32(data=6)
        self.pulse_publisher.publish(message)

    def on_words(self, message):
        """Handle a message from words."""
        self.get_logger().info(f"words: {message}")


def main(args=None):
    """Start the node and keep it running."""
    rclpy.init(args=args)
    try:
        node = QualitiesNode()
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
