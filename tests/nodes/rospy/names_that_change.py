#!/usr/bin/env python3
"""What is assigned twice is known where one of the values is there for sure."""
import sys

import rospy
from std_msgs.msg import String

TOPIC = 'first'
TOPIC = 'second'
MODE = 'idle'
GROWN = '/tree'
GROWN += '/leaf'
STEADY = 'steady'
FOR = 'nobody'

if len(sys.argv) > 1:
    PLACE = 'here'
else:
    PLACE = 'there'


def switch():
    global MODE
    MODE = 'busy'


def publishers(STEADY):
    return rospy.Publisher(STEADY, String, queue_size=1)


for FOR in ('a', 'b'):
    rospy.Publisher(FOR, String, queue_size=1)

rospy.init_node(sys.argv[1] if len(sys.argv) > 1 else 'changing')
a = rospy.Publisher(TOPIC, String, queue_size=1)
b = rospy.Publisher(MODE, String, queue_size=1)
c = rospy.Publisher(GROWN, String, queue_size=1)
d = rospy.Publisher(PLACE, String, queue_size=1)
e = rospy.Publisher(STEADY, String, queue_size=1)
f = rospy.Publisher('x' if a else 'y', String, queue_size=1)
g = rospy.Publisher('/ns/' + MODE, String, queue_size=1)
h = rospy.Publisher(f'{PLACE}/now', String, queue_size=1)
