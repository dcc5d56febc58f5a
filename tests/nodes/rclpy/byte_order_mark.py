import rclpy
from std_msgs.msg import Bool
rclpy.init()
node = rclpy.create_node('marked')
lamp = node.create_publisher(Bool, 'lamp', 1)
lamp.publish(Bool(data=True))
