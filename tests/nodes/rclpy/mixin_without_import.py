"""Part of a node: another file makes a node of it, so that this one imports no rclpy."""


class BatteryMixin:
    LOW = 0.2

    def start_battery(self):
        from sensor_msgs.msg import BatteryState
        from std_msgs.msg import Bool

        self.low = self.create_publisher(Bool, 'battery/low', 1)
        self.create_subscription(BatteryState, 'battery', self.on_battery, 10)

    def on_battery(self, state):
        if state.percentage < self.LOW:
            from std_msgs.msg import Bool
            self.low.publish(Bool(data=True))
