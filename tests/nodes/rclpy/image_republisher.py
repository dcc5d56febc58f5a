import cv2
import rclpy
from cv_bridge import CvBridge
from rclpy.node import Node
from rclpy.qos import (QoSDurabilityPolicy, QoSHistoryPolicy, QoSProfile,
                       QoSReliabilityPolicy)
from sensor_msgs.msg import CameraInfo, CompressedImage, Image


class ImageRepublisher(Node):
    """Makes compressed images of raw ones."""

    def __init__(self):
        super().__init__('image_republisher', namespace='camera')
        qos = QoSProfile(
            reliability=QoSReliabilityPolicy.BEST_EFFORT,
            durability=QoSDurabilityPolicy.VOLATILE,
            history=QoSHistoryPolicy.KEEP_LAST,
            depth=1)
        self.bridge = CvBridge()
        self.pub = self.create_publisher(CompressedImage, topic='image/compressed', qos_profile=qos)
        self.sub = self.create_subscription(
            msg_type=Image,
            topic='image',
            callback=self.image_cb,
            qos_profile=qos)
        self.info = self.create_subscription(qos_profile=QoSProfile(depth=1), callback=lambda info: self.get_logger().info(info.distortion_model), msg_type=CameraInfo, topic='camera_info')

    def image_cb(self, msg):
        frame = self.bridge.imgmsg_to_cv2(msg, desired_encoding='bgr8')
        ok, packed = cv2.imencode('.jpg', frame)
        if ok:
            self.pub.publish(CompressedImage(header=msg.header, format='jpeg', data=packed.tobytes()))


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(ImageRepublisher())
