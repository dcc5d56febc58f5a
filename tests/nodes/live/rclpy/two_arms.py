import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Float64, String


class LeftArm(Node):
    def __init__(self):
        super().__init__('left_arm')
        self.angle_pub = self.create_publisher(Float64, 'left/angle', 10)
        self.create_subscription(Float64, 'left/move', self.on_move, 10)
        self.create_subscription(String, 'command', self.on_command, 10)

    def on_move(self, msg):
        self.angle_pub.publish(msg)

    def on_command(self, msg):
        self.angle_pub.publish(Float64(data=float(len(msg.data))))


class RightArm(Node):
    def __init__(self):
        super().__init__('right_arm')
        self.angle_pub = self.create_publisher(Float64, 'right/angle', 10)
        self.create_subscription(Float64, 'right/move', self.on_move, 10)
        self.create_subscription(String, 'command', self.on_command, 10)

    def on_move(self, msg):
        self.angle_pub.publish(Float64(data=-msg.data))

    def on_command(self, msg):
        self.angle_pub.publish(Float64(data=-float(len(msg.data))))


def main():
    rclpy.init()
    executor = SingleThreadedExecutor()
    arms = [LeftArm(), RightArm()]
    for arm in arms:
        executor.add_node(arm)
    try:
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        for arm in arms:
            arm.destroy_node()


if __name__ == '__main__':
    main()
