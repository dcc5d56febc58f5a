#!/usr/bin/env python3
import rospy
from std_msgs.msg import Float32


def clamp(value, low, high):
    return max(low, min(high, value))


class Clamp:
    def __init__(self):
        self.low = rospy.get_param("~low", -1.0)
        self.high = rospy.get_param("~high", 1.0)
        self.pub = rospy.Publisher("clamped", Float32, queue_size=10)
        rospy.Subscriber("unclamped", Float32, self.callback)

    def callback(self, msg):
        out = Float32()
        out.data = clamp(msg.data, self.low, self.high)
        self.pub.publish(out)


if __name__ == "__main__":
    rospy.init_node("clamp")
    Clamp()
    rospy.spin()
