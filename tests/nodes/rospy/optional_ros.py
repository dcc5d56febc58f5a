#!/usr/bin/env python3
"""Works without ROS too, and then only prints."""
import json
import os
import sys

try:
    import rospy
    from std_msgs.msg import String
except ImportError:
    rospy = None
    String = None

from settings import ALARM, TOPICS


class Sink:
    def __init__(self):
        if rospy is None:
            self.pub = None
            return
        rospy.init_node('sink')
        self.pub = rospy.Publisher('sink', String, queue_size=1)
        self.alarm = rospy.Publisher(ALARM, String, queue_size=1)
        self.state = rospy.Publisher(TOPICS['state'], String, queue_size=1)
        self.extra = rospy.Publisher(os.environ.get('EXTRA', 'extra'), String, queue_size=1)

    def write(self, record):
        text = json.dumps(record)
        if self.pub:
            self.pub.publish(text)
        else:
            sys.stdout.write(text)
