#!/usr/bin/env python
"""Types that no one can tell from this file alone."""
import importlib

import roslib.message
import rospy
import rostopic
from rospy import AnyMsg
from std_msgs.msg import String

from .msg import Local
from helpers.messages import Wrapped
from my_types import *

try:
    from new_msgs.msg import Status
except ImportError:
    from old_msgs.msg import Status


class Envelope(object):
    pass


def listen(topic, kind):
    return rospy.Subscriber(topic, kind, heard)


def heard(msg):
    pass


rospy.init_node('types_unknown')
rospy.Subscriber('any', rospy.AnyMsg, heard)
rospy.Subscriber('any2', AnyMsg, heard)
rospy.Subscriber('status', Status, heard)
rospy.Subscriber('mine', Envelope, heard)
rospy.Subscriber('wrapped', Wrapped, heard)
rospy.Subscriber('local', Local, heard)
rospy.Subscriber('found', rostopic.get_topic_class('found')[0], heard)
rospy.Subscriber('loaded', getattr(importlib.import_module('std_msgs.msg'), 'String'), heard)
for topic, kind in [('a', String), ('b', AnyMsg)]:
    rospy.Subscriber(topic, kind, heard)
rospy.spin()
