#!/usr/bin/env python
import rospy
from std_msgs.msg import *
from geometry_msgs.msg import *
from sensor_msgs.msg import LaserScan

def on_twist(t):
    text.publish(String(str(t.linear.x)))

rospy.init_node('stars')
text = rospy.Publisher('text', String, queue_size=1)
goal = rospy.Publisher('goal', PoseStamped, queue_size=1)
rospy.Subscriber('cmd_vel', Twist, on_twist)
rospy.Subscriber('scan', LaserScan, lambda s: None)
rospy.spin()
