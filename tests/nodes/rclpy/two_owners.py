import rclpy
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Int8, String


class Left:
    def __init__(self):
        self.node = rclpy.create_node('left')
        self.pub = self.node.create_publisher(Int8, 'out', 1)

    def listen(self):
        self.sub = self.node.create_subscription(Int8, 'in', self.heard, 1)

    def heard(self, msg):
        self.pub.publish(msg)


class Right:
    def __init__(self):
        self.node = Node('right')
        self.pub = self.node.create_publisher(String, 'out', 1)
        self.node.create_timer(1.0, self.tick)

    def tick(self):
        self.pub.publish(String())


def main():
    rclpy.init()
    executor = MultiThreadedExecutor()
    for owner in (Left(), Right()):
        executor.add_node(owner.node)
    executor.spin()
