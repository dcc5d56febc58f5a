import asyncio
import threading
from threading import Timer

import rclpy
from rclpy.clock import Clock, ClockType
from rclpy.node import Node
from rclpy.timer import Timer as RosTimer

PERIOD = 0.5


class Watchdog(Node):
    def __init__(self):
        super().__init__('watchdog')
        self.python = threading.Timer(1.0, self.bark)
        self.python.start()
        Timer(2.0, self.bark).start()
        self.ros: RosTimer = self.create_timer(PERIOD, self.bark)
        self.steady = self.create_timer(1e-2, self.bark, clock=Clock(clock_type=ClockType.STEADY_TIME))
        self.guarded = self.create_timer(self.period(), self.sleep)
        self.rate = self.create_rate(2)

    def period(self):
        return PERIOD * 2

    def bark(self):
        self.get_logger().warning('woof')

    async def sleep(self):
        await asyncio.sleep(0.1)


async def main():
    rclpy.init()
    node = Watchdog()
    asyncio.get_event_loop().call_later(1.0, node.bark)
    while rclpy.ok():
        rclpy.spin_once(node, timeout_sec=0)
        await asyncio.sleep(0.01)


asyncio.run(main())
