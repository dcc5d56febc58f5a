import rclpy
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Trigger


class Broken(Node):
    def __init__(self):
        super().__init__('broken')
        self.pub = self.create_publisher(String, 'out', 1)
        self.count = = 0
        self.srv = self.create_service(Trigger, 'count', self.answer)

    def answer(self, request, response)
        response.success = True
        return response

    def tick(self):
        self.pub.publish(String(data='%d' % self.count))
        self.count++


def main():
    rclpy.init()
    node = Broken()
    timer = node.create_timer(0.5, node.tick)
    rclpy.spin(node)
