#!/usr/bin/env python3
import rospy
from std_msgs.msg import Int64


class OddEven:

    def __init__(self, ns):
        self.pub_odd = rospy.Publisher("{}/odd".format(ns), Int64, queue_size=10)
        self.pub_even = rospy.Publisher("{}/even".format(ns), Int64, queue_size=10)
        self.sub = rospy.Subscriber("{}/number".format(ns), Int64, self.split)

    def split(self, msg):
        pub = self.pub_odd if msg.data % 2 else self.pub_even
        pub.publish(msg)


if __name__ == "__main__":
    rospy.init_node("odd_even")
    OddEven("/odd_even")
    rospy.spin()
