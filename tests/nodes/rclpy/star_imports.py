import rclpy
from rclpy.node import *
from std_msgs.msg import *
from geometry_msgs.msg import *
from std_srvs.srv import *


class Stars(Node):
    def __init__(self):
        super().__init__('stars')
        self.pub = self.create_publisher(String, 'text', 1)
        self.sub = self.create_subscription(Twist, 'cmd_vel', self.on_twist, 1)
        self.srv = self.create_service(Trigger, 'hush', self.hush)

    def on_twist(self, twist):
        self.pub.publish(String(data=str(twist)))

    def hush(self, request, response):
        return response


def main():
    rclpy.init()
    rclpy.spin(Stars())
