import rclpy
from rclpy.node import Node
from rclpy.qos import *
from rclpy.qos import QoSPresetProfiles as Presets
from rclpy.duration import Duration
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from nav_msgs.msg import OccupancyGrid
from sensor_msgs.msg import Imu, PointCloud2

LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


class Quality(Node):
    DEPTH = 5

    def __init__(self):
        super().__init__('qos')
        self.map = self.create_publisher(OccupancyGrid, '/map', LATCHED)
        self.cloud = self.create_publisher(
            PointCloud2, 'points', Presets.SENSOR_DATA.value,
            event_callbacks=PublisherEventCallbacks(deadline=self.late))
        events = SubscriptionEventCallbacks(deadline=self.late, liveliness=lambda e: None)
        self.imu = self.create_subscription(
            Imu,
            'imu',
            self.on_imu,
            QoSProfile(
                depth=self.DEPTH,
                deadline=Duration(seconds=0.1),
                reliability=ReliabilityPolicy.BEST_EFFORT,
            ),
            event_callbacks=events,
            raw=False,
        )

    def late(self, event):
        self.get_logger().warn(f'{event.total_count} late')

    def on_imu(self, imu):
        pass


def main():
    rclpy.init()
    rclpy.spin(Quality())
