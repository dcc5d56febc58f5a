import rclpy

from std_msgs.msg import String
from std_srvs.srv import Empty

node = None


def callback(msg):
    node.get_logger().info('I heard: "%s"' % msg.data)


def clear(request, response):
    return response


def main(args=None):
    global node
    rclpy.init(args=args)

    node = rclpy.create_node('minimal_subscriber')

    subscription = node.create_subscription(String, 'topic', callback, 10)
    subscription  # prevents a warning
    service = node.create_service(Empty, 'clear', clear)

    while rclpy.ok():
        rclpy.spin_once(node)

    node.destroy_service(service)
    node.destroy_node()
    rclpy.shutdown()


if __name__ == '__main__':
    main()
