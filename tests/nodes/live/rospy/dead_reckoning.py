#!/usr/bin/env python
import math

import rospy
from geometry_msgs.msg import Pose2D, Twist
from std_srvs.srv import Empty, EmptyResponse

x, y, theta = 0.0, 0.0, 0.0
DT = 0.5


def twist_cb(twist):
    global x, y, theta
    theta += twist.angular.z * DT
    x += twist.linear.x * math.cos(theta) * DT
    y += twist.linear.x * math.sin(theta) * DT
    pose = Pose2D(x, y, theta)
    pub.publish(pose)


def reset(req):
    global x, y, theta
    x = y = theta = 0.0
    pub.publish(Pose2D())
    return EmptyResponse()


rospy.init_node('dead_reckoning', disable_signals=False)
pub = rospy.Publisher('pose2d', Pose2D, queue_size=10)
sub = rospy.Subscriber('cmd_vel', Twist, twist_cb)
srv = rospy.Service('reset_pose', Empty, reset)
rospy.spin()
