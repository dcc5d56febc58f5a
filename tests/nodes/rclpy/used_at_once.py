"""Publishes, calls and leaves."""
import rclpy
from std_msgs.msg import String
from std_srvs.srv import Empty

rclpy.init()
node = rclpy.create_node('once')
node.create_publisher(String, 'said', 1).publish(String(data='once'))
rclpy.spin_until_future_complete(node, node.create_client(Empty, 'reset').call_async(Empty.Request()))
send = node.create_publisher(String, 'late', 1).publish
(node
    .create_publisher(String, 'chained', 1)
    .publish(String()))
print(node.get_parameter('use_sim_time').value); send(String(data='bye'))
