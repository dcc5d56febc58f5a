import rclpy
from std_msgs.msg import String
from std_srvs.srv import Trigger
from robot_common.base import RobotNode
from robot_common import nodes


class Speaker(RobotNode):
    def __init__(self):
        super().__init__('speaker')
        self.sub = self.create_subscription(String, 'say', self.say, 10)
        self.srv = self.create_service(Trigger, 'hush', self.hush)

    def say(self, msg):
        print(msg.data)

    def hush(self, request, response):
        response.success = True
        return response


class Microphone(nodes.SensorNode):
    def __init__(self, **kwargs):
        super().__init__('microphone', **kwargs)
        self.pub = self.create_publisher(String, 'heard', 10)


def main():
    rclpy.init()
    rclpy.spin(Speaker())
