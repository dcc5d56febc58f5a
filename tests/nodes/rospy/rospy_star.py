#!/usr/bin/env python
from rospy import *
from std_msgs.msg import String

def heard(msg):
    loginfo(msg.data)

init_node('star')
pub = Publisher('said', String, queue_size=1)
sub = Subscriber('heard', String, heard)
text = get_param('~text', 'hi')
timer = Timer(Duration(1), lambda e: pub.publish(text))
spin()
