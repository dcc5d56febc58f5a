#!/usr/bin/env python
import rospy
from std_msgs.msg import Float32, Float64

rospy.init_node('wheels')
left, right = (rospy.Publisher('wheel/left', Float64, queue_size=1),
               rospy.Publisher('wheel/right', Float64, queue_size=1))
a, b = rospy.Publisher('a', Float32, queue_size=1), rospy.Publisher('b', Float32, queue_size=1)
c = d = rospy.Publisher('cd', Float32, queue_size=1)
pubs = {
    'e': rospy.Publisher('e', Float32, queue_size=1),
    'f': [rospy.Publisher('f0', Float32, queue_size=1), rospy.Publisher('f1', Float32, queue_size=1)],
}
pubs['g'] = rospy.Publisher('g', Float32, queue_size=1)
(h, *rest) = (1, rospy.Publisher('h', Float32, queue_size=1), 3)
while not rospy.is_shutdown():
    for p in (left, right):
        p.publish(0.5)
    rospy.sleep(1)
