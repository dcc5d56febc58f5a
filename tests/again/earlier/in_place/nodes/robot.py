#!/usr/bin/env python3
"""A node that somebody wrote."""
import rospy
from std_msgs.msg import String, Int32


def on_command(msg):
    print('heard')  # by hand
    rospy.loginfo(msg.data)


def on_count(message):
    rospy.loginfo("count: %s", message)


MINE = "mine"  # by hand
def main():
    rospy.init_node("robot")
    status = rospy.Publisher("status", String, queue_size=10)
    chatter_pub = rospy.Publisher("chatter", String, queue_size=10)
    second_pub = rospy.Publisher("second", Int32, queue_size=10)
    rospy.Subscriber("count", Int32, on_count)
    rate = rospy.Rate(5)
    while not rospy.is_shutdown():
        status.publish("fine")
        chatter_pub.publish(String(data="hello"))
        second_pub.publish(Int32(data=5))
        rate.sleep()


main()
