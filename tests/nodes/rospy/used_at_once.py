#!/usr/bin/env python
"""Publishes, calls and sets once, then leaves: the manner of small scripts."""
import rospy
from std_msgs.msg import String
from std_srvs.srv import Empty

rospy.init_node('once', disable_signals=True)
rospy.Publisher('said', String, queue_size=1, latch=True).publish('once')
rospy.ServiceProxy('reset', Empty)()
rospy.ServiceProxy('clear', Empty).call()
rospy.Service('stop', Empty, lambda _: []).spin()
send = rospy.Publisher('late', String, queue_size=1).publish
(rospy.Publisher('chained', String, queue_size=1)
    .publish(rospy.wait_for_message('heard', String)))
send('bye'); rospy.signal_shutdown('done')
