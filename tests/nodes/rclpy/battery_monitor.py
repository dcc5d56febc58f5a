import rclpy as r
from rclpy.node import Node as RosNode
from sensor_msgs.msg import BatteryState
from std_msgs.msg import Bool as Flag, Float32
from std_srvs.srv import Trigger

LOW_TOPIC = 'battery/low'


class BatteryMonitor(RosNode):
    SERVICE = '~/report'

    def __init__(self):
        RosNode.__init__(self, 'battery_monitor')
        self.state = None
        self.low = self.create_publisher(Flag, LOW_TOPIC, 1)
        self.level, self.volts = (
            self.create_publisher(Float32, 'battery/level', 10),
            self.create_publisher(Float32, 'battery/volts', 10))
        self.create_subscription(BatteryState, 'battery_state', self.state_cb, 10)
        self.srv = self.create_service(Trigger, self.SERVICE, self.report)
        self.create_timer(1, self.tick)

    def state_cb(self, state):
        self.state = state

    def report(self, request, response):
        response.success = self.state is not None
        response.message = repr(self.state)
        return response

    def tick(self):
        if self.state:
            self.low.publish(Flag(data=self.state.percentage < 0.2))
            self.level.publish(Float32(data=self.state.percentage))


def main():
    r.init()
    r.spin(BatteryMonitor())
    r.shutdown()
