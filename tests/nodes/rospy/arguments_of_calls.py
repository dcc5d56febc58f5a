#!/usr/bin/env python
"""What a function is called with, where the file says so, and where others may call it too."""
import functools
import sys

import actionlib
import rospy
from control_msgs.msg import GripperCommandAction
from std_msgs.msg import String


class Server(object):
    def __init__(self, name):
        self.action = actionlib.SimpleActionServer(name, GripperCommandAction, self.run, False)
        self.state = rospy.Publisher(name + '/state', String, queue_size=1)

    def run(self, goal):
        pass


class Sided(object):
    def __init__(self, side):
        self.pub = rospy.Publisher('arm_%s' % side, String, queue_size=1)


class Handed(object):
    def __init__(self, topic):
        self.pub = rospy.Publisher(topic, String, queue_size=1)

    def hear(self, topic):
        rospy.Subscriber(topic, String, print)


def once(topic):
    return rospy.Publisher(topic, String, queue_size=1)


def wrapped(topic, text):
    rospy.Publisher(topic, String, queue_size=1).publish(text)


def repeated(topic):
    return rospy.Publisher(topic, String, queue_size=1)


def spread(topic):
    return rospy.Publisher(topic, String, queue_size=1)


def read(topic):
    return rospy.Publisher(topic, String, queue_size=1)


def same(topic):
    return rospy.Publisher(topic, String, queue_size=1)


def start(name):
    rospy.init_node(name)
    Server('gripper')
    for side in ('left', 'right'):
        Sided(side)
    makers = [Handed]
    handed = Handed('handed')
    handed.hear('a')
    once(topic='single')
    wrapped('wrapped', '')
    rospy.on_shutdown(functools.partial(wrapped, 'other', 'gone'))
    for i in range(3):
        repeated('repeated_%d' % i)
    spread(*sys.argv)
    read(rospy.get_param('~out', 'out'))
    same('alike'), same('alike')


start('arguments')
