import rclpy
from geometry_msgs.msg import Twist
from rclpy.action import ActionClient
from control_msgs.action import GripperCommand
from std_msgs.msg import Float64


class Wheel:
    def __init__(self, node, side):
        self.node = node
        self.pub = node.create_publisher(Float64, side + '/effort', 1)

    def turn(self, effort):
        self.pub.publish(Float64(data=effort))


class Gripper:
    def __init__(self, parent):
        self._parent = parent
        self._client = ActionClient(self._parent, GripperCommand, 'gripper/command')
        self._parent.create_subscription(Float64, 'gripper/width', self._width, 1)

    def _width(self, msg):
        self.width = msg.data


class Base(rclpy.node.Node):
    def __init__(self):
        super().__init__('base')
        self.wheels = [Wheel(self, side) for side in ('left', 'right')]
        self.gripper = Gripper(self)
        self.sub = self.create_subscription(Twist, 'cmd_vel', self.drive, 1)

    def drive(self, twist):
        for wheel in self.wheels:
            wheel.turn(twist.linear.x)


def main():
    rclpy.init()
    rclpy.spin(Base())
