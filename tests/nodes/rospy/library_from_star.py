#!/usr/bin/env python3
"""A module of the robot brings rospy along; this file imports nothing else."""
from robot_tools import *


class Picker:
    def __init__(self):
        self.colour = message_filters.Subscriber('/camera/colour', Image)
        self.found = rospy.Publisher('/found', PoseArray, queue_size=1)
        rospy.Subscriber('/pick', Bool, self.pick)
        self.pub = Publisher('/not_ros', Text)

    def pick(self, message):
        self.found.publish(self.look())


rospy.init_node('picker')
picker = Picker()
rospy.spin()
