import rclpy
from rclpy.node import Node
from std_msgs.msg import String

OPTIONS = {'qos_profile': 1}


class Unpacked(Node):
    def __init__(self, *args, **kwargs):
        super().__init__('unpacked', *args, **kwargs)
        self.a = self.create_publisher(String, 'a', **OPTIONS)
        self.b = [self.create_publisher(*spec, 1) for spec in [(String, 'b')]]
        self.c = self.create_publisher(String, *['c'], 1)
        self.d = self.create_subscription(String, 'd', self.heard, *[1])

    def heard(self, msg):
        pass


rclpy.init()
rclpy.spin(Unpacked())
