#!/usr/bin/env python
# Lets numbers through while it is open.
import rospy
from std_msgs.msg import Bool, Int32, String

is_open = True
passed = 0


def on_open(msg):
    global is_open
    is_open = msg.data
    state_pub.publish("open" if is_open else "closed")


def on_number(msg):
    global passed
    if not is_open:
        rospy.logwarn("closed: dropping %d", msg.data)
        state_pub.publish("dropped")
        return
    passed += 1
    out_pub.publish(msg)


if __name__ == '__main__':
    rospy.init_node('gate')
    out_pub = rospy.Publisher('out', Int32, queue_size=10)
    state_pub = rospy.Publisher('gate/state', String, queue_size=1, latch=True)
    state_pub.publish("open")
    rospy.Subscriber('in', Int32, on_number)
    rospy.Subscriber('open', Bool, on_open, queue_size=1)
    rospy.spin()
