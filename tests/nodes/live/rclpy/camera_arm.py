#!/usr/bin/env python3
from typing import Dict

import rclpy
from rclpy.node import Node
from rclpy.publisher import Publisher
from std_msgs.msg import Float32

JOINTS = ('pan', 'tilt')
PREFIX = 'joint'


class CameraArm(Node):

    def __init__(self, node_name: str = 'camera_arm', ns: str = 'head') -> None:
        super().__init__(node_name, namespace=ns)
        self.joints: Dict[str, Publisher] = {
            joint: self.create_publisher(Float32, f'{PREFIX}/{joint}', 1) for joint in JOINTS
        }
        self.error_pub = self.create_publisher(Float32, '~/error', 1)
        self.global_pub = self.create_publisher(Float32, '/camera_arm/last', 1)
        self.create_subscription(Float32, 'aim', self._aim, 1)
        self.create_subscription(Float32, '/camera_arm/home', self._home, 1)

    def _aim(self, msg: Float32) -> None:
        self._move(msg.data)
        self.error_pub.publish(Float32(data=0.25))

    def _home(self, msg: Float32) -> None:
        self._move(0.0)
        self.global_pub.publish(msg)

    def _move(self, angle: float) -> None:
        for joint in self.joints.values():
            joint.publish(Float32(data=angle))


def main():
    rclpy.init()
    try:
        rclpy.spin(CameraArm())
    except KeyboardInterrupt:
        pass


if __name__ == '__main__':
    main()
