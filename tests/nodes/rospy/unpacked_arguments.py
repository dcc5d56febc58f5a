#!/usr/bin/env python
import rospy
from std_msgs.msg import String

SPECS = [('a', String), ('b', String)]
OPTIONS = {'queue_size': 1, 'latch': True}

rospy.init_node('unpacked', **{'anonymous': True})
pubs = [rospy.Publisher(*spec, queue_size=1) for spec in SPECS]
one = rospy.Publisher('one', String, **OPTIONS)
two = rospy.Publisher('two', *[String], queue_size=1)
sub = rospy.Subscriber('three', String, one.publish, *[], **OPTIONS)
four = rospy.Publisher(**everything)
