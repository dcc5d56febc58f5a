#!/usr/bin/env python
import sys
import rospy
from std_msgs.msg import String

def callback(msg):
	print "heard", msg.data
	print >>sys.stderr, "%d letters" % len(msg.data)

def main():
	rospy.init_node('py2_listener')
	rospy.Subscriber('chatter', String, callback)
	pub = rospy.Publisher(u'echo', String)
	try:
		count = rospy.get_param('~count')
	except KeyError, missing:
		print 'no', missing
		count = 0x10L
	print
	print("counting to", count),
	rospy.spin()

if __name__ == '__main__':
	main()
