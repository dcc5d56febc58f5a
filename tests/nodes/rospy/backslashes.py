#!/usr/bin/env python
import rospy
from functools import partial
from std_msgs.msg import Bool, Float32
from std_srvs.srv import SetBool, SetBoolResponse

ROOM, DOOR = 'hall', \
    'front'


def on_lock(door, request):
    return SetBoolResponse(success=True, message=door)


def on_light(message, \
             room):
    rospy.loginfo('%s: %s', room, message.data)


rospy.init_node( \
    'caretaker', \
    anonymous=True)
servers = [
    rospy.Service('doors/%s/lock' % (DOOR, \
                                     ), \
        SetBool, partial(on_lock, \
                         DOOR)), \
]
light = rospy.Subscriber('light', \
                         Bool, \
                         on_light, \
                         ROOM)
warm, cold = \
    rospy.Publisher('warm', \
                    Float32, queue_size=1), \
    rospy.Publisher(data_class=Float32, \
                    name='co' \
                         'ld', queue_size=1)
rospy.spin()
