#!/usr/bin/env python
import rospy
from std_msgs.msg import Bool
rospy.init_node('marked')
lamp = rospy.Publisher('lamp', Bool, queue_size=1)
lamp.publish(True)
