#!/usr/bin/env python
"""Callbacks that are wrapped first and get a name of their own for that."""
import functools

import rospy
from sensor_msgs.msg import Image
from std_srvs.srv import Trigger, TriggerResponse


def on_call(side, request):
    return TriggerResponse(success=True, message=side)


class Stereo(object):
    def __init__(self, node):
        left = functools.partial(self.on_image, 'left')
        self.left = rospy.Subscriber('left', Image, left)
        self.right = rospy.Subscriber('right', Image, right)
        either = functools.partial(self.on_image, 'a')
        if node:
            either = functools.partial(self.on_pair, 'b')
        self.either = rospy.Subscriber('either', Image, either)
        calling = functools.partial(on_call, 'left')
        self.service = rospy.Service('call', Trigger, calling)
        made = self.make('left')
        self.made = rospy.Subscriber('made', Image, made)

    def on_image(self, side, image):
        pass

    def on_pair(self, side, image):
        pass

    def make(self, side):
        return functools.partial(self.on_image, side)


right = functools.partial(print, 'right')
rospy.init_node('stereo')
Stereo(None)
rospy.spin()
