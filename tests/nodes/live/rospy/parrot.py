#!/usr/bin/env python3
# Repeats what it hears, backwards and loud.
import rospy
import std_msgs.msg

rospy.init_node("parrot")

backwards = rospy.Publisher("backwards", std_msgs.msg.String, queue_size=10)
loud = rospy.Publisher("loud", std_msgs.msg.String, queue_size=10)
length = rospy.Publisher("length", std_msgs.msg.UInt8, queue_size=10)


def hear(msg):
    length.publish(len(msg.data))
    loud.publish(msg.data.upper())


rospy.Subscriber("words", std_msgs.msg.String, hear)
rospy.Subscriber("secrets", std_msgs.msg.String, lambda msg: backwards.publish(msg.data[::-1]))
rospy.spin()
