#!/usr/bin/env python3
"""One name, many scopes."""
import rospy
from std_msgs.msg import Int8, String

TOPIC = 'module'
OTHER = 'other'
LOOP = 'loop'


class Scoped:
    TOPIC = 'class'
    inside = rospy.Publisher(TOPIC, String, queue_size=1)

    def method(self):
        a = rospy.Publisher(TOPIC, String, queue_size=1)
        b = rospy.Publisher(self.TOPIC, String, queue_size=1)
        OTHER = 'local'
        c = rospy.Publisher(OTHER, String, queue_size=1)
        d = [rospy.Publisher(LOOP, String, queue_size=1) for LOOP in 'xyz']
        e = rospy.Publisher(LOOP, String, queue_size=1)
        f = lambda TOPIC: rospy.Publisher(TOPIC, String, queue_size=1)

    def shadow(self):
        from example_msgs.msg import String
        return rospy.Publisher(OTHER, String, queue_size=1)


def closure():
    topic = 'outer'
    kept = 'kept'

    def change():
        nonlocal topic
        topic = 'inner'
        return rospy.Publisher(kept, String, queue_size=1)

    change()
    return rospy.Publisher(topic, String, queue_size=1)


def read(path):
    with open(path) as topic:
        for line in topic:
            rospy.Publisher(line.strip(), String, queue_size=1)
    try:
        pass
    except ValueError as OTHER:
        rospy.Publisher(OTHER, String, queue_size=1)
    kind = String if path else Int8
    rospy.Publisher('kind', kind, queue_size=1)


def fallback(topic=None, name=OTHER):
    topic = topic or 'fallback'
    rospy.Publisher(topic, String, queue_size=1)
    rospy.Publisher(name, String, queue_size=1)


def given(topic=None):
    if topic is None:
        topic = 'given'
    rospy.Publisher(topic, String, queue_size=1)


given('taken')
rospy.init_node(TOPIC + '_node')
