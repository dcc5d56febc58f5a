import rclpy
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import BatteryState
from std_msgs.msg import Bool

from .base import DeviceNode
from .names import BATTERY_TOPIC, LATCHED


class Battery(DeviceNode):
    def __init__(self):
        super().__init__('battery', default_rate=1.0)
        self.full_voltage = self.declare_parameter('full_voltage', 25.2).value
        self.cells = self.declare_parameter('cells', 6).value
        self.state = self.create_publisher(BatteryState, BATTERY_TOPIC, qos_profile_sensor_data)
        self.low = self.create_publisher(Bool, 'battery_low', LATCHED)
        self.voltage = self.full_voltage

    def poll(self):
        self.voltage -= 0.001
        msg = BatteryState(header=self.header(), voltage=self.voltage)
        msg.percentage = self.voltage / self.full_voltage
        msg.present = True
        self.state.publish(msg)
        self.low.publish(Bool(data=msg.percentage < 0.2))


def main():
    rclpy.init()
    node = Battery()
    rclpy.spin(node)
    rclpy.shutdown()
