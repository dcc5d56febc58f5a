#!/usr/bin/env python
# -*- coding: latin-1 -*-
# Zählt die Türen, © Jürgen
import rospy
from std_msgs.msg import String

rospy.init_node('tueren')
größe = rospy.get_param('~größe', 3)
pub = rospy.Publisher('tueren', String, queue_size=1)
pub.publish('Größe: é'); zu = rospy.Publisher('türen/zu', String, queue_size=1)
