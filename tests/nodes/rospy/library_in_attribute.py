#!/usr/bin/env python3
"""A class that is handed the library, so that its tests can hand it another."""
import rospy
import std_msgs.msg as messages
from std_srvs.srv import Trigger, TriggerResponse


class Base(object):
    ros = rospy


class Wheel(Base):
    def __init__(self, ros=rospy):
        self.lib = ros
        self.msgs = messages
        self.speed = self.lib.Publisher('speed', self.msgs.Float32, queue_size=1)
        self.inherited = self.ros.Subscriber('brake', self.msgs.Bool, self.brake)

    def brake(self, message):
        self.speed.publish(0.0)


class Motor(object):
    def __init__(self, api):
        self.api = None
        self.api = api
        self.fake = rospy if api is None else api
        self.api.Publisher('handed_in', messages.String)
        self.fake.Publisher('one_or_the_other', messages.String)


class Arm(object):
    ros = None

    def __init__(self):
        self.ros = rospy
        self.client = self.ros
        self.stop = self.client.Service('stop', Trigger, self.on_stop)
        self.client.init_node('arm')

    def on_stop(self, request):
        return TriggerResponse(True, self.ros.get_param('~reason', 'asked'))


class Changed(object):
    def __init__(self, other):
        self.ros = rospy
        self.ros = other
        self.ros.Publisher('whose', messages.String)


Arm()
Wheel()
