import rclpy
from rclpy.node import Node
from std_msgs.msg import String, Int32


class A(Node):
    def __init__(self):
        super().__init__("a")
        self.create_publisher(String, "x", 10)


class B(Node):
    def __init__(self):
        super().__init__("b")
        print("b")  # by hand
        self.create_publisher(String, "y", 10)
        self.count_sub = self.create_subscription(Int32, "count", self.on_count, 10)

    def on_count(self, message):
        self.get_logger().info(f"count: {message}")


def main():
    rclpy.init()
    rclpy.spin(A())
