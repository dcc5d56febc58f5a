#!/usr/bin/env python3
# A node as somebody wrote it by hand, to be changed by change_node.plastron.
import random

import rospy
from std_msgs.msg import Float32, String

ROOM = 4.0  # metres from wall to wall


class Sonar:
    def __init__(self):
        self.pub = rospy.Publisher('distance', Float32, queue_size=1)
        rospy.Subscriber('mode', String, self.on_mode)
        self.noise = 0.02

    def on_mode(self, msg):
        # a precise sonar is slow, a fast one is noisy
        self.noise = {'precise': 0.005, 'fast': 0.05}.get(msg.data, 0.02)

    def measure(self):
        return random.gauss(ROOM / 2, self.noise)

    def run(self):
        rate = rospy.Rate(10)
        while not rospy.is_shutdown():
            self.pub.publish(self.measure())
            rate.sleep()


if __name__ == '__main__':
    rospy.init_node('sonar')
    Sonar().run()
