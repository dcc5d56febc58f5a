#!/usr/bin/env python3
"""Mean of the last samples."""
import rospy
from std_msgs.msg import Float64
from std_srvs.srv import Trigger, TriggerResponse


class Averager(object):

    def __init__(self):
        self.window = rospy.get_param('~window', 3)
        self.samples = []
        self.mean_pub = rospy.Publisher('mean', Float64, queue_size=10)
        self.sub = rospy.Subscriber('samples', Float64, self.sample_cb)
        self.srv = rospy.Service('clear', Trigger, self.handle_clear)

    def sample_cb(self, msg):
        self.samples.append(msg.data)
        self.samples = self.samples[-self.window:]
        self.mean_pub.publish(Float64(sum(self.samples) / len(self.samples)))

    def handle_clear(self, req):
        n = len(self.samples)
        self.samples = []
        return TriggerResponse(success=n > 0, message='forgot %d' % n)


def main():
    rospy.init_node('averager')
    Averager()
    rospy.spin()


if __name__ == '__main__':
    main()
