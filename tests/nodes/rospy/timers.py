#!/usr/bin/env python
import threading
from threading import Timer

import rospy
from rospy import Timer as RosTimer

PERIOD = 0.5


class Watchdog(object):
    def __init__(self):
        self.python = threading.Timer(1.0, self.bark)
        self.python.start()
        Timer(2.0, self.bark).start()
        self.ros = rospy.Timer(rospy.Duration(PERIOD), self.bark)
        self.once = rospy.Timer(rospy.Duration(nsecs=10), callback=self.bark, oneshot=True)
        self.third = RosTimer(rospy.Duration.from_sec(3.0), self.bark)
        period = rospy.Duration(1)
        self.fourth = rospy.Timer(callback=self.bark, period=period)
        self.rate = rospy.Rate(1 / PERIOD)

    def bark(self, event=None):
        rospy.logwarn('woof')


rospy.init_node('watchdog')
Watchdog()
rospy.Timer(rospy.Duration(60), lambda event: rospy.signal_shutdown('late'), oneshot=True)
rospy.spin()
