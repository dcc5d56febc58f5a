import rclpy
import rclpy.node
from rclpy.qos import QoSProfile, QoSReliabilityPolicy, qos_profile_sensor_data
from std_msgs.msg import Float32 as Number


class SensorFilter(rclpy.node.Node):
    """A low-pass filter over what a sensor says."""

    alpha = 0.5

    def __init__(self):
        rclpy.node.Node.__init__(self, "sensor_filter")
        best_effort = QoSProfile(depth=5, reliability=QoSReliabilityPolicy.BEST_EFFORT)
        self.value = None
        self.out = self.create_publisher(Number, "filtered", best_effort)
        self.raw = self.create_publisher(Number, "raw_copy", qos_profile_sensor_data)
        self.sub = self.create_subscription(
            msg_type=Number,
            topic="raw",
            callback=self.on_raw,
            qos_profile=qos_profile_sensor_data,
        )

    def on_raw(self, msg):
        old = msg.data if self.value is None else self.value
        self.value = old + self.alpha * (msg.data - old)
        self.raw.publish(msg)
        self.out.publish(Number(data=self.value))


if __name__ == "__main__":
    rclpy.init()
    try:
        rclpy.spin(SensorFilter())
    except KeyboardInterrupt:
        pass
