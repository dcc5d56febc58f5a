import message_filters
import rclpy
from message_filters import ApproximateTimeSynchronizer, Subscriber as FilterSubscriber
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import CameraInfo, Image
from stereo_msgs.msg import DisparityImage


class Stereo(Node):
    def __init__(self):
        super().__init__('stereo')
        left = message_filters.Subscriber(self, Image, 'left/image', qos_profile=qos_profile_sensor_data)
        right = message_filters.Subscriber(self, Image, 'right/image')
        infos = [FilterSubscriber(self, CameraInfo, f'{side}/camera_info') for side in ('left', 'right')]
        self.sync = ApproximateTimeSynchronizer([left, right, *infos], 10, 0.05)
        self.sync.registerCallback(self.both)
        self.pub = self.create_publisher(DisparityImage, 'disparity', 1)

    def both(self, left, right, left_info, right_info):
        self.pub.publish(DisparityImage(header=left.header))


def main():
    rclpy.init()
    rclpy.spin(Stereo())
