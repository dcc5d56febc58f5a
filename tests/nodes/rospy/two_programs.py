#!/usr/bin/env python
import sys
import rospy
from std_msgs.msg import String


def talker():
    rospy.init_node('talker')
    pub = rospy.Publisher('chatter', String, queue_size=1)
    rospy.sleep(1)
    pub.publish('hello')


def listener():
    rospy.init_node('listener')
    rospy.Subscriber('chatter', String, lambda m: sys.stdout.write(m.data))
    rospy.spin()


if __name__ == '__main__':
    talker() if 'talk' in sys.argv else listener()
