import threading

import rclpy
from rclpy.executors import ExternalShutdownException
from std_msgs.msg import Float64
from std_srvs.srv import SetBool


class Heater:
    """Has a node rather than being one."""

    def __init__(self, node):
        self._node = node
        self.isOn = False
        self.powerPub = node.create_publisher(Float64, 'heater/power', 10)
        self.srv = node.create_service(SetBool, 'heater/switch', self.handleSwitch)
        self.sub = node.create_subscription(Float64, 'heater/limit', self.handleLimit, 10)
        self.limit = 100.0

    def handleSwitch(self, request, response):
        response.success = self.isOn != request.data
        self.isOn = request.data
        self._node.get_logger().info('switched %s' % ('on' if self.isOn else 'off'))
        return response

    def handleLimit(self, msg):
        self.limit = msg.data

    def loop(self):
        rate = self._node.create_rate(50)
        while rclpy.ok():
            self.powerPub.publish(Float64(data=self.limit if self.isOn else 0.0))
            rate.sleep()


def spin(node):
    try:
        rclpy.spin(node)
    except ExternalShutdownException:
        pass


def main():
    rclpy.init()
    node = rclpy.create_node('threaded')
    heater = Heater(node)
    thread = threading.Thread(target=spin, args=(node,), daemon=True)
    thread.start()
    try:
        heater.loop()
    except (KeyboardInterrupt, rclpy.exceptions.ROSInterruptException):
        pass


if __name__ == '__main__':
    main()
