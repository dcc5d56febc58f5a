#!/usr/bin/env python3
"""A node that somebody wrote."""
import rclpy
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Empty


class Robot(Node):
    def __init__(self):
        super().__init__("robot")
        self.status = self.create_publisher(String, "status", 10)
        self.create_subscription(String, "command", self.on_command, 10)
        self.create_service(Empty, "reset", self.on_reset)
        self.create_timer(0.2, self.tick)

    def on_command(self, msg):
        self.get_logger().info(msg.data)

    def on_reset(self, request, response):
        return response

    def tick(self):
        self.status.publish(String(data="fine"))


def main():
    rclpy.init()
    rclpy.spin(Robot())


main()
