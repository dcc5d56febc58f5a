#!/usr/bin/env python
import rospy
from nav_msgs.msg import Path
from std_msgs.msg import String


class Once(object):
    def __init__(self):
        self.topic = 'once'
        self.ns = '/planner'
        self.connect()

    def connect(self):
        self.pub = rospy.Publisher(self.topic, String, queue_size=1)
        self.path = rospy.Publisher(self.ns + '/path', Path, queue_size=1)


class Twice(object):
    def __init__(self):
        self.topic = 'first'
        self.pub = rospy.Publisher(self.topic, String, queue_size=1)

    def move(self):
        self.pub.unregister()
        self.topic = 'second'
        self.pub = rospy.Publisher(self.topic, String, queue_size=1)


class FromOutside(object):
    def __init__(self, topic):
        self.topic = topic
        self.server = rospy.get_param('~server', 'plans')
        self.sub = rospy.Subscriber(self.topic, String, self.heard)
        self.plans = rospy.Subscriber(self.server, Path, self.heard)

    def heard(self, msg):
        pass


rospy.init_node('attributes')
nodes = [Once(), Twice(), FromOutside('outside')]
rospy.spin()
