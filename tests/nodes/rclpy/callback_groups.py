import threading
import time

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Int32
from std_srvs.srv import Trigger


class Groups(Node):
    def __init__(self):
        super().__init__('groups')
        self.alone = MutuallyExclusiveCallbackGroup()
        together = ReentrantCallbackGroup()
        self.sub = self.create_subscription(Int32, 'number', self.slow, 10, callback_group=together)
        self.client = self.create_client(Trigger, 'work', callback_group=self.alone)
        self.service = self.create_service(Trigger, 'again', self.again, callback_group=together)
        self.timer = self.create_timer(timer_period_sec=0.5, callback=self.tick, callback_group=self.alone)
        self.guard = self.create_guard_condition(self.tick)
        self.lock = threading.Lock()

    def slow(self, msg):
        with self.lock:
            time.sleep(msg.data)

    def again(self, request, response):
        response.success = self.client.call(Trigger.Request()).success
        return response

    def tick(self):
        self.guard.trigger()


def main():
    rclpy.init()
    try:
        node = Groups()
        executor = MultiThreadedExecutor()
        executor.add_node(node)
        threading.Thread(target=executor.spin, daemon=True).start()
        rate = node.create_rate(2)
        while rclpy.ok():
            rate.sleep()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
