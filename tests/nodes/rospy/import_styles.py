#!/usr/bin/env python
import rospy
import std_msgs.msg
import std_msgs.msg as sm
import geometry_msgs.msg, nav_msgs.srv
import sensor_msgs
from std_msgs import msg
from geometry_msgs import msg as geo, msg
from std_srvs import srv
from sensor_msgs.msg import (
    Image,        # pictures
    LaserScan as Scan,
)
from nav_msgs.msg import Odometry; from std_srvs.srv import Trigger as T
from actionlib_msgs.msg._GoalID import GoalID

rospy.init_node('imports')
a = rospy.Publisher('a', std_msgs.msg.String, queue_size=1)
b = rospy.Publisher('b', sm.Int32, queue_size=1)
c = rospy.Publisher('c', geometry_msgs.msg.Twist, queue_size=1)
d = rospy.Publisher('d', geo.Pose, queue_size=1)
f = rospy.Publisher('f', Image, queue_size=1)
g = rospy.Publisher('g', Scan, queue_size=1)
h = rospy.Publisher('h', Odometry, queue_size=1)
i = rospy.Publisher('i', GoalID, queue_size=1)
j = rospy.ServiceProxy('j', srv.Empty)
k = rospy.ServiceProxy('k', nav_msgs.srv.GetMap)
l = rospy.ServiceProxy('l', T)
