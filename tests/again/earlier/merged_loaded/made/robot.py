#!/usr/bin/env python3
"""A node that somebody wrote."""
import rclpy
from rclpy.node import Node
from std_msgs.msg import String, Int32


class Robot(Node):
    def __init__(self):
        super().__init__("robot")
        self.status = self.create_publisher(String, "status", 10)
        self.chatter_pub = self.create_publisher(String, "chatter", 10)
        self.create_timer(0.2, self.tick)
        self.count_sub = self.create_subscription(Int32, "count", self.on_count, 10)
        self.early_sub = self.create_subscription(String, "early", self.on_early, 10)

    def on_command(self, msg):
        print('heard')  # by hand
        self.get_logger().info(msg.data)

    def tick(self):
        self.status.publish(String(data="fine"))
        self.chatter_pub.publish(String(data="hello"))
        print('sent')  # by hand

    def on_count(self, message):
        self.get_logger().info(f"count: {message}")

    def on_early(self, message):
        self.get_logger().info(f"early: {message}")


MINE = "mine"  # by hand
def main():
    rclpy.init()
    rclpy.spin(Robot())


main()
