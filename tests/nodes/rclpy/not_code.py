"""Says nothing.

Example::

    class Talker(Node):
        def __init__(self):
            super().__init__('talker')
            self.create_publisher(String, 'chatter', 10)
"""
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

SOURCE = """
node = rclpy.create_node('generated')
node.create_subscription(String, 'generated', print, 10)
"""

# class Old(Node):
#     def __init__(self):
#         super().__init__('old')


class Quiet(Node):
    """Had self.create_publisher(String, 'chatter', 10) once."""

    def __init__(self):
        super().__init__('quiet')
        # self.pub = self.create_publisher(String, 'chatter', 10)
        self.sub = self.create_subscription(String, 'heard', self.heard, 10)  # self.create_timer(1, self.tick)

    def heard(self, msg):
        '''self.create_client(Empty, 'empty')'''
        self.get_logger().debug("self.get_parameter('debug') would tell")


def main():
    rclpy.init()
    exec(SOURCE)
    rclpy.spin(Quiet())
