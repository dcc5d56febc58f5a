from enum import Enum, auto

import rclpy
from rclpy.node import Node
from std_msgs.msg import Empty, String


class State(Enum):
    IDLE = auto()
    RUNNING = auto()
    DONE = auto()


class Sequencer(Node):
    def __init__(self):
        super().__init__('sequencer')
        self.state = State.IDLE
        self.pub = self.create_publisher(String, '~/state', 10)
        for name, handler in (('start', self.start), ('stop', self.stop)):
            self.create_subscription(Empty, name, handler, 10)
        self.timer = None

    def start(self, _):
        if self.state is State.IDLE:
            self.state = State.RUNNING
            self.timer = self.create_timer(2.0, self.finish)

    def stop(self, _):
        self.state = State.IDLE
        if self.timer is not None:
            self.destroy_timer(self.timer)

    def finish(self):
        self.timer.cancel()
        self.state = State.DONE
        self.pub.publish(String(data=self.state.name))


def main():
    rclpy.init()
    with rclpy.context.Context():
        rclpy.spin(Sequencer())
