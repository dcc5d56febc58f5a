#!/usr/bin/env python3
"""A node that somebody wrote."""
import rospy
from std_msgs.msg import String, Int32


class Robot:
    def __init__(self):
        rospy.init_node("robot")
        self.status = rospy.Publisher("status", String, queue_size=10)
        self.chatter_pub = rospy.Publisher("chatter", String, queue_size=10)
        rospy.Timer(rospy.Duration(0.2), self.tick)
        self.count_sub = rospy.Subscriber("count", Int32, self.on_count, queue_size=10)

    def on_command(self, msg):
        print('heard')  # by hand
        rospy.loginfo(msg.data)

    def tick(self, event=None):
        self.status.publish(String(data="fine"))
        self.chatter_pub.publish(String(data="hello"))

    def on_count(self, message):
        rospy.loginfo(f"count: {message}")


MINE = "mine"  # by hand
def main():
    Robot()
    rospy.spin()


main()
