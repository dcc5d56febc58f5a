#!/usr/bin/env python
import rospy
from std_msgs.msg import String

def callback(data):
    rospy.loginfo(rospy.get_caller_id() + " heard %s", data.data)
    ack.publish("ok: " + data.data)

def listener():
    global ack
    rospy.init_node('listener')
    ack = rospy.Publisher('ack', String, queue_size=10)

    rospy.Subscriber("chat", String, callback)

    # spin() simply keeps python from exiting until this node is stopped
    rospy.spin()

if __name__ == '__main__':
    listener()
