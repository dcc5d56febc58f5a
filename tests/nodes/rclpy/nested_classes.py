import rclpy
from rclpy.node import Node
from std_msgs.msg import Bool, Empty


class Robot:
    """Only a name space."""

    class Arm(Node):
        class Gripper:
            def __init__(self, arm):
                self.arm = arm

        def __init__(self):
            super().__init__('arm')
            self.gripper = self.Gripper(self)
            self.pub = self.create_publisher(Bool, 'gripped', 1)

            def grip(msg):
                self.pub.publish(Bool(data=True))

            self.sub = self.create_subscription(Empty, 'grip', grip, 1)

    def __init__(self):
        self.arm = Robot.Arm()


def build():
    class Leg(Node):
        def __init__(self):
            super().__init__('leg')
            self.create_subscription(Empty, 'step', self.step, 1)

        def step(self, _):
            pass

    return Leg()


if __name__ == '__main__':
    rclpy.init()
    robot = Robot()
    rclpy.spin(robot.arm)
