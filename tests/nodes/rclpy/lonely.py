import rclpy
from rclpy.node import Node


class Lonely(Node):
    def __init__(self):
        super().__init__('lonely')
        self.get_logger().info('waiting')


class Nameless(Node):
    """Its name comes from whoever makes it."""


def main():
    rclpy.init()
    rclpy.spin(Lonely())
