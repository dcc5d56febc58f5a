"""Everything here creates something; only the node's are ROS's."""
import boto3
import paho.mqtt.client as mqtt
import rclpy
from PyQt5.QtCore import QTimer
from rclpy.node import Node
from std_msgs.msg import String

from factory import Factory
from robots.actions import ActionServer, ActionClient


class Broker:
    def create_publisher(self, kind, topic, depth):
        return (kind, topic, depth)

    def declare_parameter(self, name, value):
        setattr(self, name, value)


class Gateway(Node):
    def __init__(self):
        super().__init__('gateway')
        self.broker = Broker()
        self.fake = self.broker.create_publisher(String, 'fake', 10)
        self.broker.declare_parameter('host', 'localhost')
        self.session = boto3.Session()
        self.s3 = self.session.create_client('s3', region_name='eu')
        factory = Factory()
        factory.create_service('api', 'http', self.up)
        factory.create_timer(1.0, self.up)
        Factory().create_subscription('fake', String, self.up, 10)
        self.qt = QTimer()
        self.qt.timeout.connect(self.up)
        self.action = ActionServer(self, String, 'fake_action', self.up)
        self.caller = ActionClient(self, String, 'fake_action')
        self.mqtt = mqtt.Client()
        self.mqtt.create_publisher('mqtt', String, 1)
        self.real = self.create_publisher(String, 'real', 10)

    def up(self, *args):
        self.real.publish(String(data=str(args)))


def main():
    rclpy.init()
    rclpy.spin(Gateway())
