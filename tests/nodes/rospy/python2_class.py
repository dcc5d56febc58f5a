#! /usr/bin/python
# vim: noexpandtab
import rospy, math, string
import std_msgs.msg, sensor_msgs.msg

class Wall:
	def __init__(self):
		self.near = None
		rospy.init_node("wall_follower")
		self.pub = rospy.Publisher("cmd", std_msgs.msg.Float32)
		self.sub = rospy.Subscriber("scan", sensor_msgs.msg.LaserScan, self.scan)

	def scan(self, data):
		if data.ranges[0] <> data.ranges[-1]:
			raise ValueError, "no wall at %s" % `data.header.stamp`
		exec "self.near = min(data.ranges)"
		self.pub.publish(self.near)
		print "near: %.2f" % self.near

	def run(self):
		while not rospy.is_shutdown():
			  rospy.sleep(0.1)

Wall().run()
