import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Tabs(Node):
	def __init__(self):
		super(Tabs, self).__init__("tabs")
		self.pub = self.create_publisher(String, "said", 10)
		if True:
			self.timer = self.create_timer(1, self.tick)

	def tick(self):
		print "tick", self.get_name()
		self.pub.publish(String(data="tick"))

rclpy.init()
rclpy.spin(Tabs())
