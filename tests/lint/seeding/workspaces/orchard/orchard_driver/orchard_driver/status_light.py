import rclpy
from rclpy.node import Node
from std_msgs.msg import Bool as BoolMsg
from std_msgs.msg import ColorRGBA, String

from orchard_driver.names import LATCHED


class StatusLight(Node):
    low_topic = 'battery_low'

    def __init__(self):
        super().__init__('status_light')
        self.color = ColorRGBA(r=0.0, g=1.0, b=0.0, a=1.0)
        self.color_pub = self.create_publisher(ColorRGBA, 'light/color', 10)
        self.create_subscription(BoolMsg, self.low_topic, self.on_low, LATCHED)
        self.create_subscription(String, 'mode', lambda msg: self.set_mode(msg.data), 10)
        self.create_timer(0.2, self.blink)

    def on_low(self, msg: BoolMsg) -> None:
        self.color.r = 1.0 if msg.data else 0.0

    def set_mode(self, mode):
        self.color.b = 1.0 if mode == 'harvest' else 0.0

    def blink(self):
        self.color_pub.publish(self.color)


def main():
    rclpy.init()
    rclpy.spin(StatusLight())
    rclpy.shutdown()
