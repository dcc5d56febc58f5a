#!/usr/bin/env python3
import rclpy
from lift_msgs.msg import LiftStatus, Pallet
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from sensor_msgs.msg import Temperature


class PalletLogger(Node):
    def __init__(self):
        super().__init__('pallet_logger')
        self.count = 0
        qos = QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.pub = self.create_publisher(Pallet, 'pallets', qos)
        self.create_subscription(LiftStatus, 'lift/status', self.on_status, 10)
        self.create_subscription(Temperature, 'scale/temperature', self.on_temperature, 10)

    def on_status(self, status):
        if status.state == LiftStatus.IDLE and status.height > 2.0:
            self.count += 1
            pallet = Pallet(id=str(self.count), weight=12.0)
            pallet.position.z = status.height
            self.pub.publish(pallet)

    def on_temperature(self, msg):
        self.get_logger().debug(f'{msg.temperature}')


def main():
    rclpy.init()
    rclpy.spin(PalletLogger())
    rclpy.shutdown()


if __name__ == '__main__':
    main()
