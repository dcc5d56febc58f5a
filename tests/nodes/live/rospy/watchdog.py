#!/usr/bin/env python3
import rospy
from std_msgs.msg import Empty, String
from std_srvs.srv import SetBool, SetBoolResponse


class Watchdog:
    """Barks until it is fed; sleeps where it is told to."""

    def __init__(self):
        self.fed = False
        self.asleep = False
        self.pub = rospy.Publisher("bark", String, queue_size=1)
        self.sub = rospy.Subscriber("feed", Empty, self.feed_cb)
        self.srv = rospy.Service("~sleep", SetBool, self.sleep_cb)
        rospy.Timer(rospy.Duration(0.04), self.timer_cb)

    def feed_cb(self, msg):
        self.fed = True

    def sleep_cb(self, req):
        self.asleep = req.data
        return SetBoolResponse(True, "zzz" if req.data else "awake")

    def timer_cb(self, event=None):
        if self.asleep:
            text = "zzz"
        elif self.fed:
            text = "..."
        else:
            text = "woof"
        self.pub.publish(text)


if __name__ == "__main__":
    rospy.init_node("watchdog")
    dog = Watchdog()
    rospy.spin()
