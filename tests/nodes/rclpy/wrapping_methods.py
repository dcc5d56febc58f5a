"""A base class that wraps the methods of Node, and a node that uses it."""
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Base(Node):
    def __init__(self, node_name, **kwargs):
        super().__init__(node_name, **kwargs)
        self.made = []

    def advertise(self, kind, topic, depth=10):
        self.made.append(self.create_publisher(kind, topic, depth))
        return self.made[-1]

    def listen(self, kind, topic):
        def decorate(callback):
            self.made.append(self.create_subscription(kind, topic, callback, 10))
            return callback
        return decorate

    def parameter(self, name, default=None):
        return self.declare_parameter(name, default).value

    def destroy(self):
        for one in self.made:
            self.destroy_publisher(one)
        super().destroy_node()


class Talker(Base):
    def __init__(self):
        super().__init__('talker', namespace='demo')
        self.pub = self.advertise(String, 'chatter')
        self.extra = super().create_publisher(String, 'extra', 1)
        self.rate = self.parameter('rate', 1.0)
        self.listen(String, 'heard')(self.heard)
        self.create_timer(1 / self.rate, lambda: self.pub.publish(String(data='hi')))

    def heard(self, msg):
        pass


rclpy.init()
rclpy.spin(Talker())
