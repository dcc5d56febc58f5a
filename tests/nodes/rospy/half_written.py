#!/usr/bin/env python
import rospy
from geometry_msgs.msg import PoseStamped
from std_msgs.msg import String


def whole(msg):
    out.publish(msg.header.frame_id)


def half(msg):
    if msg.pose.position.x >
        return


rospy.init_node('half_written')
out = rospy.Publisher('frame', String, queue_size=1)
rospy.Subscriber('goal', PoseStamped, whole)
rospy.spin()

def unfinished(