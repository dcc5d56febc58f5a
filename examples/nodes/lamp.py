#!/usr/bin/env python3
"""A ROS 2 node as somebody wrote it by hand, to be changed by change_node_ros2.plastron."""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Bool, Float32


class Lamp(Node):
    def __init__(self):
        super().__init__('lamp')
        self.pub = self.create_publisher(Float32, 'brightness', 10)
        self.create_subscription(Bool, 'light', self.on_light, 10)
        self.timer = self.create_timer(0.1, self.dim)
        self.goal = 1.0
        self.brightness = 0.0

    def on_light(self, msg):
        self.goal = 1.0 if msg.data else 0.0

    def dim(self):
        # an old lamp: it takes a second to get there
        step = max(-0.1, min(0.1, self.goal - self.brightness))
        self.brightness += step
        self.pub.publish(Float32(data=self.brightness))


def main():
    rclpy.init()
    lamp = Lamp()
    try:
        rclpy.spin(lamp)
    except KeyboardInterrupt:
        pass
    finally:
        lamp.destroy_node()
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
