#!/usr/bin/env python3
import rospy
from std_msgs.msg import Int32
from std_srvs.srv import Empty, EmptyResponse


class Tally:
    name = "tally"

    def __init__(self):
        self.total = 0
        self.pub = rospy.Publisher("total", Int32, queue_size=10)
        self.add_sub = rospy.Subscriber("add", Int32, self.on_add)
        self.reset_srv = rospy.Service("reset", Empty, self.on_reset)

    def on_add(self, msg):
        self.total += msg.data
        self.publish_total()

    def on_reset(self, req):
        self.total = 0
        self.publish_total()
        return EmptyResponse()

    def publish_total(self):
        msg = Int32()
        msg.data = self.total
        self.pub.publish(msg)


class CarefulTally(Tally):
    """Counts nothing that is negative."""

    def on_add(self, msg):
        if msg.data >= 0:
            Tally.on_add(self, msg)


if __name__ == "__main__":
    rospy.init_node(Tally.name)
    tally = CarefulTally()
    rospy.spin()
