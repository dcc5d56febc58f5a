import rclpy
from rclpy.node import Node
from std_msgs.msg import Int32, \
    Int64


class Counter(Node):
    """Counts
    what it hears."""

    def __init__(self):
        super().__init__('counter')
        self.count = 0
        self.pub = self.create_publisher(Int64, 'count',
                                         10)
        self.create_subscription(Int32, 'tick', self.tick, 10)

    def tick(self, msg):
        self.count += msg.data
        self.pub.publish(Int64(data=self.count))


if __name__ == '__main__':
    rclpy.init()
    rclpy.spin(Counter())
