#!/usr/bin/env python3
"""The ROS 2 node navigator."""

import rclpy
from geometry_msgs.msg import PoseStamped
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import Header


class NavigatorNode(Node):
    """Publishes messages."""

    def __init__(self):
        """Join the ROS graph."""
        super().__init__("navigator")
        self.goal_pose_publisher = self.create_publisher(
            PoseStamped,
            "goal_pose",
            QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL),
        )
        self.goal_pose_timer = self.create_timer(1 / 5, self.publish_goal_pose)
        self.goal_pose_is_heard = False

    def publish_goal_pose(self):
        """Publish to goal_pose, once: when somebody listens."""
        was_heard = self.goal_pose_is_heard
        self.goal_pose_is_heard = self.goal_pose_publisher.get_subscription_count() > 0
        if not self.goal_pose_is_heard:
            self.get_logger().warning(
                "goal_pose: nobody listens yet", throttle_duration_sec=5.0, skip_first=True
            )
        elif was_heard:
            # A subscription that is there for so long knows this publisher too.
            self.goal_pose_timer.cancel()
            message = PoseStamped(header=Header(frame_id="map"))
            message.header.stamp = self.get_clock().now().to_msg()
            self.goal_pose_publisher.publish(message)


def main(args=None):
    """Start the node and keep it running."""
    rclpy.init(args=args)
    try:
        node = NavigatorNode()
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
