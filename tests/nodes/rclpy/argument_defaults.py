import rclpy
from rclpy.node import Node
from std_msgs.msg import String
from sensor_msgs.msg import Imu


class Relay(Node):
    def __init__(self, name='relay', source='in', *, target: str = 'out', extra=None):
        super().__init__(name)
        self.target = target
        self.sub = self.create_subscription(String, source, self.relay, 10)
        self.pub = self.create_publisher(String, self.target, 10)
        self.log = self.create_publisher(String, extra, 10)

    def listen(self, topic='imu'):
        self.create_subscription(Imu, topic, self.relay, 10)

    def say(self, topic='said', text='-'):
        self.create_publisher(String, topic, 10).publish(String(data=text))

    def relay(self, msg):
        self.pub.publish(msg)


def main(args=None):
    rclpy.init(args=args)
    relay = Relay()
    relay.listen('imu/data')
    relay.say(text='hello')
    rclpy.spin(relay)
