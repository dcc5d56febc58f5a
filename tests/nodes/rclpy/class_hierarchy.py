from abc import abstractmethod

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64, String


class Sensor(Node):
    TOPIC = 'overridden'
    UNIT = 'unit'

    def __init__(self, name):
        super().__init__(name)
        self.pub = self.create_publisher(Float64, self.TOPIC, 10)
        self.unit = self.create_publisher(String, self.UNIT, 10)
        self.timer = self.create_timer(1.0, self.tick)

    @abstractmethod
    def read(self):
        ...

    def tick(self):
        self.pub.publish(Float64(data=self.read()))


class Thermometer(Sensor):
    TOPIC = 'temperature'

    def __init__(self):
        super().__init__('thermometer')

    def read(self):
        return 20.5


class Barometer(Sensor):
    TOPIC = 'pressure'

    def __init__(self):
        Sensor.__init__(self, 'barometer')
        self.raw = self.create_publisher(Float64, self.TOPIC + '/raw', 10)

    def read(self):
        return 1013.2


def main():
    rclpy.init()
    executor = rclpy.executors.SingleThreadedExecutor()
    for kind in (Thermometer, Barometer):
        executor.add_node(kind())
    executor.spin()
