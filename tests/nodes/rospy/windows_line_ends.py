#!/usr/bin/env python
import rospy
from std_msgs.msg import Int32, \
    Int64


class Counter:
    """Counts
    what it hears."""

    def __init__(self):
        self.count = 0
        self.pub = rospy.Publisher('count', Int64,
                                   queue_size=1)
        rospy.Subscriber('tick', Int32, self.tick)

    def tick(self, msg):
        self.count += msg.data
        self.pub.publish(self.count)


if __name__ == '__main__':
    rospy.init_node('counter')
    Counter()
    rospy.spin()
