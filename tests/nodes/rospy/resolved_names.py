#!/usr/bin/env python
import sys
import rospy
from sensor_msgs.msg import Image
from std_msgs.msg import String

rospy.init_node('relay', argv=['relay', 'in:=camera'], anonymous=True)
args = rospy.myargv(argv=sys.argv)
rospy.Subscriber(rospy.resolve_name('in'), Image, lambda m: out.publish(m))
out = rospy.Publisher(rospy.remap_name('out'), Image, queue_size=1)
info = rospy.Publisher(args[1], String, queue_size=1)
mine = rospy.Publisher(rospy.get_name() + '/status', String, queue_size=1)
deep = rospy.Publisher(rospy.names.ns_join(rospy.get_namespace(), 'deep'), String, queue_size=1)
found = rospy.Publisher(rospy.get_param('~prefix') + '/found', String, queue_size=1)
rospy.spin()
