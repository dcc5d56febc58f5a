import rclpy
from functools import partial
from rclpy.qos import qos_profile_sensor_data
from std_msgs.msg import Float32, String

rclpy.init()
node = rclpy.create_node('collector')
latest = {}
report = node.create_publisher(String, 'report', 5)


def keep(msg, name):
    latest[name] = msg.data
    text = ', '.join('%s=%.1f' % (key, latest[key]) for key in sorted(latest))
    report.publish(String(data=text))


temperature = node.create_subscription(Float32, 'temperature', partial(keep, name='t'), qos_profile_sensor_data)
humidity = node.create_subscription(Float32, 'humidity', partial(keep, name='h'), qos_profile_sensor_data)
pressure = node.create_subscription(Float32, 'pressure', lambda msg: keep(msg, 'p'), 10)

try:
    rclpy.spin(node)
except KeyboardInterrupt:
    pass
