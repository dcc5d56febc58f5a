#!/usr/bin/env python3
import rospy
from std_msgs.msg import Bool, ColorRGBA


class Blinker:
    def __init__(self):
        self.colour = ColorRGBA(1, 0, 0, 1)
        self.enabled = rospy.get_param('~enabled', True)
        self.pub = rospy.Publisher('~colour', ColorRGBA, queue_size=1)
        rospy.Subscriber('~enable', Bool, self.enable)
        rospy.Subscriber('~set', ColorRGBA, self.set)

    def enable(self, msg):
        self.enabled = msg.data

    def set(self, msg):
        self.colour = msg

    def run(self):
        rate = rospy.Rate(40)
        off = ColorRGBA()
        while not rospy.is_shutdown():
            self.pub.publish(self.colour if self.enabled else off)
            rate.sleep()


if __name__ == '__main__':
    rospy.init_node('blinker')
    try:
        Blinker().run()
    except rospy.ROSInterruptException:
        pass
