#!/usr/bin/env python3
import rospy
from std_msgs.msg import Float32, Int32MultiArray, UInt8

BINS = 4


class Histogram(object):
    def __init__(self, topic):
        self.counts = [0] * BINS
        self.pub = rospy.Publisher(topic + '/histogram', Int32MultiArray, queue_size=1)
        self.last_pub = rospy.Publisher(topic + '/bin', UInt8, queue_size=1)
        self.sub = rospy.Subscriber(topic, Float32, self.add, queue_size=1)

    def add(self, msg):
        index = int(min(max(msg.data, 0.0), 0.999) * BINS)
        self.counts[index] += 1
        self.last_pub.publish(index)
        self.pub.publish(Int32MultiArray(data=self.counts))


if __name__ == '__main__':
    rospy.init_node('histogram')
    histogram = Histogram('share')
    rospy.spin()
