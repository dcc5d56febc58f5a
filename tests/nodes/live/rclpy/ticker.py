import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node

from std_msgs.msg import Bool, String


class Ticker(Node):

    def __init__(self):
        super().__init__('ticker')
        self.text = 'tick'
        self.is_quiet = False
        self.text_publisher = self.create_publisher(String, 'text', 10)
        self.quiet_publisher = self.create_publisher(Bool, 'is_quiet', 10)
        self.create_subscription(String, 'set_text', self.set_text_callback, 10)
        self.create_subscription(Bool, 'set_quiet', self.set_quiet_callback, 10)
        timer_period = 0.05  # seconds
        self.text_timer = self.create_timer(timer_period, self.text_timer_callback)
        self.quiet_timer = self.create_timer(0.02, self.quiet_timer_callback)

    def set_text_callback(self, msg):
        self.text = msg.data

    def set_quiet_callback(self, msg):
        self.is_quiet = msg.data

    def text_timer_callback(self):
        msg = String()
        msg.data = self.text
        self.text_publisher.publish(msg)

    def quiet_timer_callback(self):
        self.quiet_publisher.publish(Bool(data=self.is_quiet))


def main(args=None):
    try:
        rclpy.init(args=args)
        ticker = Ticker()
        rclpy.spin(ticker)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == '__main__':
    main()
