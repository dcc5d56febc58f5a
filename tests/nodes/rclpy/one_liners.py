import rclpy; from rclpy.node import Node; from std_msgs.msg import String, Bool
class Short(Node):
    def __init__(self): super().__init__('short'); self.p = self.create_publisher(String, 'p', 1); self.q = self.create_publisher(Bool, 'q', 1)
    def start(self): (s := self.create_subscription(String, 's', self.p.publish, 1)); return s
    def make(self): return lambda topic: self.create_publisher(Bool, topic, 1)
class Empty(Node):
    def __init__(self, **options): super(Empty, self).__init__('empty', **options)
rclpy.init(); rclpy.spin(Short())
