import rclpy
import tf2_ros
from geometry_msgs.msg import PointStamped, TransformStamped
from rclpy.node import Node
from tf2_geometry_msgs import do_transform_point
from tf2_ros import Buffer, StaticTransformBroadcaster, TransformListener


class Frames(Node):
    def __init__(self):
        super().__init__('frames')
        self.declare_parameter('target_frame', 'map')
        self.target = self.get_parameter('target_frame').get_parameter_value().string_value
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self, spin_thread=True)
        self.moving = tf2_ros.TransformBroadcaster(self)
        self.fixed = StaticTransformBroadcaster(self)
        self.pub = self.create_publisher(PointStamped, 'point_out', 10)
        self.sub = self.create_subscription(PointStamped, 'clicked_point', self.on_point, 10)

    def on_point(self, point):
        try:
            t = self.buffer.lookup_transform(self.target, point.header.frame_id, rclpy.time.Time())
            self.pub.publish(do_transform_point(point, t))
        except tf2_ros.TransformException as e:
            self.get_logger().info(f'no transform: {e}')


def main():
    rclpy.init()
    node = Frames()
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
