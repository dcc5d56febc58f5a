#!/usr/bin/env python3
import math

import rclpy
import tf2_ros
from geometry_msgs.msg import Quaternion, TransformStamped, Twist
from nav_msgs.msg import Odometry
from rclpy.node import Node
from tf2_ros import TransformBroadcaster
from tf2_ros.buffer import Buffer
from tf2_ros.transform_listener import TransformListener


class OdometryNode(Node):
    def __init__(self):
        super(OdometryNode, self).__init__('odometry')
        self.x = self.y = self.th = 0.0
        self.twist = Twist()
        self.rate = 50.0
        self.broadcaster = TransformBroadcaster(self)
        self.static = tf2_ros.StaticTransformBroadcaster(self)
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.pub = self.create_publisher(Odometry, 'odom', 10)
        self.sub = self.create_subscription(Twist, 'cmd_vel', self.on_twist, 10)
        self.timer = self.create_timer(1.0 / self.rate, self.update)

    def on_twist(self, msg):
        self.twist = msg

    def update(self):
        dt = 1.0 / self.rate
        self.th += self.twist.angular.z * dt
        self.x += self.twist.linear.x * math.cos(self.th) * dt
        self.y += self.twist.linear.x * math.sin(self.th) * dt
        t = TransformStamped()
        t.header.stamp = self.get_clock().now().to_msg()
        t.header.frame_id, t.child_frame_id = 'odom', 'base_link'
        t.transform.rotation = Quaternion(z=math.sin(self.th / 2), w=math.cos(self.th / 2))
        self.broadcaster.sendTransform(t)
        self.pub.publish(Odometry(header=t.header))


def main():
    rclpy.init()
    rclpy.spin(OdometryNode())
