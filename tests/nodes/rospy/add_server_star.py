#!/usr/bin/env python
from beginner_tutorials.srv import *
from std_msgs.msg import *
from math import *
import rospy

count = 0


def handle(req):
    global count
    count += 1
    total.publish(count)
    return AddTwoIntsResponse(req.a + req.b)


rospy.init_node('add_server')
total = rospy.Publisher('~calls', Int32, queue_size=1)
s = rospy.Service('add_two_ints', AddTwoInts, handle)
print("ready")
rospy.spin()
