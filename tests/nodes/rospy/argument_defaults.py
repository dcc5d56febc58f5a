#!/usr/bin/env python3
import rospy
from sensor_msgs.msg import Imu
from std_msgs.msg import String


def listen(topic='imu/data', callback=None):
    return rospy.Subscriber(topic, Imu, callback)


def speak(topic='speech', *, latch=False):
    return rospy.Publisher(topic, String, latch=latch, queue_size=1)


class Relay:
    def __init__(self, source='in', target: str = 'out', name=None):
        self.target = target
        self.sub = rospy.Subscriber(source, String, self.relay)
        self.pub = rospy.Publisher(self.target, String, queue_size=1)
        self.log = rospy.Publisher(name, String, queue_size=1)

    def relay(self, msg):
        self.pub.publish(msg)


def main(name='relay'):
    rospy.init_node(name)
    listen()
    speak('shout')
    Relay()
    rospy.spin()


if __name__ == '__main__':
    main()
