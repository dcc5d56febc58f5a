#!/usr/bin/env python3
"""A node that somebody wrote."""
import rospy
from std_msgs.msg import String
from std_srvs.srv import Empty, EmptyResponse


def on_command(msg):
    rospy.loginfo(msg.data)


def on_reset(request):
    return EmptyResponse()


def main():
    rospy.init_node("robot")
    status = rospy.Publisher("status", String, queue_size=10)
    rospy.Subscriber("command", String, on_command)
    rospy.Service("reset", Empty, on_reset)
    rate = rospy.Rate(5)
    while not rospy.is_shutdown():
        status.publish("fine")
        rate.sleep()


main()
