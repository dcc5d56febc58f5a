#!/usr/bin/env python3
"""A node that somebody wrote."""
import atexit
import threading

import rclpy
from rclpy.executors import ExternalShutdownException
from std_msgs.msg import String, Int32

node = None


def spin():
    """Handle what comes, until ROS ends."""
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


def spin_in_thread():
    """Handle what comes in a thread, until the program ends."""
    thread = threading.Thread(target=spin, daemon=True)
    thread.start()
    atexit.register(thread.join)
    atexit.register(rclpy.try_shutdown)


def on_command(msg):
    print('heard')  # by hand
    node.get_logger().info(str(msg.data))


def on_count(message):
    node.get_logger().info(f"count: {message}")


MINE = "mine"  # by hand
def main():
    global node
    rclpy.init()
    node = rclpy.create_node("robot")
    spin_in_thread()
    status = node.create_publisher(String, "status", 10)
    chatter_pub = node.create_publisher(String, "chatter", 10)
    node.create_subscription(Int32, "count", on_count, 10)
    rate = node.create_rate(5)
    while rclpy.ok():
        status.publish(String(data="fine"))
        chatter_pub.publish(String(data="hello"))
        rate.sleep()


main()
