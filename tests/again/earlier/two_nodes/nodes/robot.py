import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class A(Node):
    def __init__(self):
        super().__init__("a")
        self.create_publisher(String, "x", 10)


class B(Node):
    def __init__(self):
        super().__init__("b")
        self.create_publisher(String, "y", 10)


def main():
    rclpy.init()
    rclpy.spin(A())
