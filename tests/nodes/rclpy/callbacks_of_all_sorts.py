import functools
from functools import partial as bind

import rclpy
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Trigger


class Planner:
    def on_text(self, msg, extra=None):
        pass

    @staticmethod
    async def static(msg):
        pass


def answer(name, request, response):
    return response


def make(name):
    return lambda msg: print(name, msg)


class Callbacks(Node):
    def __init__(self):
        super().__init__('callbacks')
        self.planner = Planner()
        self.handlers = {'x': self.planner.on_text}
        self.create_subscription(String, 'a', self.planner.on_text, 1)
        self.create_subscription(String, 'b', functools.partial(self.planner.on_text, extra=1), 1)
        self.create_subscription(String, 'c', bind(self.handle, 'c'), 1)
        self.create_subscription(String, 'd', lambda msg: self.handle('d', msg), 1)
        self.create_subscription(String, 'e', self.handlers['x'], 1)
        self.create_subscription(String, 'f', make('f'), 1)
        self.create_subscription(String, 'g', Planner.static, 1)
        self.create_subscription(String, 'h', [].append, 1)
        self.create_subscription(String, 'i', print, 1)
        self.create_service(Trigger, 'j', bind(answer, 'j'))
        self.create_service(Trigger, 'k', lambda request, response: response)
        self.create_timer(1.0, bind(self.handle, 'timer'))
        self.create_timer(callback=lambda: None, timer_period_sec=2.0)

    def handle(self, *args):
        pass


def main():
    rclpy.init()
    node = Callbacks()
    node.create_subscription(String, 'z', node.handle, 1)
    rclpy.spin(node)
