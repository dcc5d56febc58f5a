#!/usr/bin/env python3
"""Keeps a room warm; a plain script, as it grew."""
import rospy
from std_msgs.msg import Float32, String

wanted = 21.0

def on_wanted( m ):
    global wanted
    wanted = m.data   # degrees

rospy.init_node('heater')
rospy.Subscriber('wanted', Float32, on_wanted)
pub   = rospy.Publisher('temperature', Float32, queue_size=1)
state = rospy.Publisher('state', String, queue_size=1)  # 'on' or 'off'

now = 18.0
rate = rospy.Rate(20)
while not rospy.is_shutdown():
    now += 0.1 if now < wanted else -0.1
    pub.publish(now)
    state.publish('on' if now < wanted else 'off')
    rate.sleep()
