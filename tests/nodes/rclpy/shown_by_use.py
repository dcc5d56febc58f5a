"""Parts of a robot that are handed a node under another name."""
from rclpy.parameter import Parameter
from message_filters import Subscriber
from sensor_msgs.msg import Image
from std_msgs.msg import Int8


class Gripper:
    def __init__(self, robot):
        self.robot = robot
        self.robot.declare_parameter('force', 5)
        self.force = self.robot.create_publisher(Int8, 'force', 1)

    def start(self):
        self.timer = self.robot.create_timer(0.1, self.squeeze)

    def squeeze(self):
        self.force.publish(Int8(data=self.robot.get_parameter('force').value))


class Eye:
    def __init__(self, host):
        self.images = Subscriber(host, Image, 'image')
        host.create_timer(1.0, self.blink)

    def blink(self):
        pass


class Cron:
    """Has timers of its own, which are none of ROS."""

    def __init__(self, robot, host):
        self.robot = robot
        self.robot.create_timer(60.0, self.clean)
        host.declare_parameter('every', 60)

    def clean(self):
        pass


def attach(session):
    session.create_timer(1.0, print)


FULL = Parameter('force', value=10)
