#!/usr/bin/env python3
import rospy
import std_msgs.msg
from std_msgs.msg import String as Text


class Beacon:
    lamp = False

    def __init__(self):
        self.color = rospy.Publisher('beacon/color', std_msgs.msg.ColorRGBA, queue_size=1)
        self.sub = rospy.Subscriber('lamp', std_msgs.msg.Bool, lambda msg: self.switch(msg.data))
        rospy.Subscriber('survey/state', Text, self.on_state)

    def switch(self, on):
        self.lamp = on
        self.color.publish(std_msgs.msg.ColorRGBA(1, 0, 0, 1 if on else 0))

    def on_state(self, text):
        rospy.logdebug(text.data)

    def run(self):
        rospy.spin()


if __name__ == '__main__':
    rospy.init_node('beacon')
    Beacon().run()
