from functools import partial

import orchard_interfaces.msg as om
import rclpy
from orchard_interfaces.srv import CountFruits
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import CameraInfo, Image

from orchard_driver import names

SIDES = ('left', 'right')


class FruitCamera(Node):
    def __init__(self):
        super().__init__('fruit_camera')
        self.declare_parameter('min_confidence', 0.6)
        self.declare_parameter('row', 'A1')
        self.counts = {side: 0 for side in SIDES}
        for side in SIDES:
            self.create_subscription(
                Image, f'camera/{side}/image_raw', partial(self.on_image, side), qos_profile_sensor_data
            )
            self.create_subscription(
                CameraInfo,
                'camera/' + side + '/camera_info',
                lambda info, side=side: self.on_info(info, side),
                10,
            )
        self.pub = self.create_publisher(om.FruitCount, names.FRUITS, 10)
        self.srv = self.create_service(CountFruits, 'count_fruits', self.on_count)
        self.timer = self.create_timer(0.5, self.publish_counts)

    def on_image(self, side, image):
        self.counts[side] += image.height // 100

    def on_info(self, info, side):
        self.get_logger().debug(f'{side}: {info.width} x {info.height}')

    def on_count(self, request, response):
        response.count = self.make_count(request.row)
        response.success = not request.use_flash
        return response

    def make_count(self, row):
        count = om.FruitCount()
        count.header.stamp = self.get_clock().now().to_msg()
        count.header.frame_id = 'camera_link'
        count.row = row
        count.ripe = sum(self.counts.values())
        count.confidence = 0.8
        return count

    def publish_counts(self):
        count = self.make_count(self.get_parameter('row').value)
        if count.confidence >= self.get_parameter('min_confidence').value:
            self.pub.publish(count)


def main(args=None):
    rclpy.init(args=args)
    camera = FruitCamera()
    rclpy.spin(camera)
    camera.destroy_node()
    rclpy.shutdown()
