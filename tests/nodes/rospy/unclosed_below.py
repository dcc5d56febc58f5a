#!/usr/bin/env python
import rospy
from std_msgs.msg import String


class Echo:
    def __init__(self):
        self.pub = rospy.Publisher('echo', String, queue_size=1)
        self.sub = rospy.Subscriber('voice', String, self.heard)

    def heard(self, msg):
        self.pub.publish(String(data=msg.data)

    def later(self):
        return [1, 2


if __name__ == '__main__':
    rospy.init_node('echo')
    Echo()
    rospy.spin()
