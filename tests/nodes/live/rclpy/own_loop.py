#!/usr/bin/env python3
import rclpy
from std_msgs.msg import Int32, String

heard = 0


def on_number(msg):
    global heard
    heard = msg.data
    doubled.publish(Int32(data=heard * 2))


rclpy.init()
node = rclpy.create_node('own_loop')
doubled = node.create_publisher(Int32, 'twice', 10)
report = node.create_publisher(String, 'report', 10)
node.create_subscription(Int32, 'number', on_number, 10)

try:
    while rclpy.ok():
        rclpy.spin_once(node, timeout_sec=0.02)
        text = String()
        text.data = 'heard %d' % heard
        report.publish(text)
except KeyboardInterrupt:
    pass
