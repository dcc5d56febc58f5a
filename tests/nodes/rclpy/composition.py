"""Camera, detector and display in one process."""
import sys

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from sensor_msgs.msg import Image
from vision_msgs.msg import Detection2DArray


class Camera(Node):
    def __init__(self):
        super().__init__('camera')
        self.pub = self.create_publisher(Image, 'image', 1)
        self.create_rate(10)
        self.timer = self.create_timer(0.1, self.grab)

    def grab(self):
        self.pub.publish(Image())


class Detector(Node):
    def __init__(self):
        super().__init__('detector')
        self.sub = self.create_subscription(Image, 'image', self.detect, 1)
        self.pub = self.create_publisher(Detection2DArray, 'detections', 1)

    def detect(self, image):
        self.pub.publish(Detection2DArray(header=image.header))


class Display(Node):
    def __init__(self):
        super().__init__('display')
        self.create_subscription(Image, 'image', self.image, 1)
        self.create_subscription(Detection2DArray, 'detections', self.boxes, 1)

    def image(self, msg):
        self.last = msg

    def boxes(self, msg):
        self.found = msg


def main(args=sys.argv):
    rclpy.init(args=args)
    camera, detector, display = Camera(), Detector(), Display()
    watch = rclpy.create_node('watch', namespace='/tools')
    watch.create_timer(5.0, lambda: watch.get_logger().info('alive'))
    camera.declare_parameter('exposure', 10)
    executor = SingleThreadedExecutor()
    for node in (camera, detector, display, watch):
        executor.add_node(node)
    try:
        executor.spin()
    finally:
        executor.shutdown()
