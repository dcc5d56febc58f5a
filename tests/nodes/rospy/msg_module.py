#!/usr/bin/env python
import rospy
from std_msgs import msg


class Dice:
    def __init__(self):
        self.pub = rospy.Publisher('dice', msg.UInt8, queue_size=1)
        self.sub = rospy.Subscriber('roll', msg.Empty, self.roll)

    def roll(self, _):
        self.pub.publish(msg.UInt8(4))


if __name__ == '__main__':
    rospy.init_node('dice')
    Dice()
    rospy.spin()
