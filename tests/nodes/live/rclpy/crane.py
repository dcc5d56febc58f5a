import sys

import rclpy
from rclpy.executors import ExternalShutdownException
from std_msgs.msg import Bool, Float32, String


class Crane:
    def __init__(self):
        self.node = rclpy.create_node('crane')
        self.height = 0.0
        self.height_pub = self.node.create_publisher(Float32, 'height', 10)
        self.busy_pub = self.node.create_publisher(Bool, 'busy', 10)
        self.lift_sub = self.node.create_subscription(Float32, 'lift', self.on_lift, 10)
        self.say_sub = self.node.create_subscription(String, 'say', self.on_say, 10)

    def on_lift(self, msg):
        self.busy_pub.publish(Bool(data=True))
        self.height += msg.data
        self.height_pub.publish(Float32(data=self.height))
        self.busy_pub.publish(Bool(data=False))

    def on_say(self, msg):
        self.node.get_logger().info(msg.data)
        self.height_pub.publish(Float32(data=self.height))

    def close(self):
        self.node.destroy_publisher(self.busy_pub)
        self.node.destroy_publisher(self.height_pub)
        self.node.destroy_subscription(self.lift_sub)
        self.node.destroy_node()


def main(argv=sys.argv):
    rclpy.init(args=argv)
    crane = Crane()
    try:
        rclpy.spin(crane.node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        crane.close()
        print('closed')


if __name__ == '__main__':
    main()
