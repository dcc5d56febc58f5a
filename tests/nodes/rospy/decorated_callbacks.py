#!/usr/bin/env python3
import threading
from functools import wraps

import rospy
from sensor_msgs.msg import JointState
from std_srvs.srv import SetBool, SetBoolResponse

lock = threading.RLock()


def locked(function):
    @wraps(function)
    def inner(*args, **kwargs):
        with lock:
            return function(*args, **kwargs)
    return inner


def subscriber(topic, kind):
    """A decorator that subscribes what it decorates."""
    def decorate(function):
        rospy.Subscriber(topic, kind, function)
        return function
    return decorate


@subscriber('joint_states', JointState)
@locked
def on_joints(msg):
    rospy.loginfo(msg.name)


class Gripper:
    @property
    def width(self):
        return rospy.get_param('~width', 0.08)

    @locked
    def grip(self, request):
        return SetBoolResponse(success=request.data)

    def run(self):
        with lock:
            self.service = rospy.Service('grip', SetBool, self.grip)


rospy.init_node('gripper')
Gripper().run()
rospy.spin()
