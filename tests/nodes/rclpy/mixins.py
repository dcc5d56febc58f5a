import rclpy
from rclpy.lifecycle import LifecycleNode
from rclpy.node import Node
from std_msgs.msg import Header
from std_srvs.srv import SetBool


class HeartbeatMixin:
    HEARTBEAT = 'heartbeat'

    def start_heartbeat(self, period):
        self._heart = self.create_publisher(Header, self.HEARTBEAT, 1)
        self._heart_timer = self.create_timer(period, self.beat)

    def beat(self):
        self._heart.publish(Header(stamp=self.get_clock().now().to_msg()))


class Counting(object):
    """Counts, and needs no node for it."""

    def count(self):
        self.total = getattr(self, 'total', 0) + 1


class Machine(Counting, HeartbeatMixin, Node):
    def __init__(self):
        Node.__init__(self, 'machine')
        self.start_heartbeat(1.0)
        self.service = self.create_service(SetBool, 'power', self.power)

    def power(self, request, response):
        self.count()
        response.success = True
        return response


class Standby(Counting, LifecycleNode):
    def __init__(self):
        super().__init__('standby')
        self.power = self.create_client(SetBool, 'power')


def main():
    rclpy.init()
    rclpy.spin(Machine())
