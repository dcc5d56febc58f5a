import rclpy
from rclpy.node import Node
from std_msgs.msg import Int32


class Doubler(Node):

    def __init__(self):
        super().__init__('doubler')
        self.publisher_ = self.create_publisher(Int32, 'doubled', 10)
        self.subscription = self.create_subscription(
            Int32,
            'numbers',
            self.listener_callback,
            10)
        self.subscription  # prevent unused variable warning

    def listener_callback(self, msg):
        self.get_logger().info('I heard: "%d"' % msg.data)
        self.publisher_.publish(Int32(data=msg.data * 2))


def main(args=None):
    rclpy.init(args=args)
    doubler = Doubler()
    try:
        rclpy.spin(doubler)
    except KeyboardInterrupt:
        pass
    finally:
        doubler.destroy_node()
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
