#!/usr/bin/env python
import rospy
from std_msgs.msg import Int16, Int8

floor = 0

def go(msg):
    global floor
    while floor != msg.data:
        floor += 1 if msg.data > floor else -1
        pub.publish(floor)
    done.publish(Int8(floor))

if __name__ == '__main__':
    pub = rospy.Publisher('floor', Int16, queue_size=100)
    done = rospy.Publisher('arrived', Int8, queue_size=10)
    rospy.init_node('lift')
    rospy.Subscriber('go_to', Int16, go)
    rospy.spin()
