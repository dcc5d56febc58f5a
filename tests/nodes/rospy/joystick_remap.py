#!/usr/bin/env python3
# -*- coding: utf-8 -*-
"""Gibt der Maus Räder: Joystick → cmd_vel (¡olé!)."""
import rospy
from geometry_msgs.msg import Twist
from sensor_msgs.msg import Joy, JoyFeedbackArray


class Joystick:
    OUT: str = 'cmd_vel'
    AXES = {'drive': 1, 'turn': 0}

    pub = None

    def __init__(self):
        # räder drehen sich: ≥ 1 m/s
        self.axes = {k: rospy.get_param('~axis_{}'.format(k), v) for k, v in self.AXES.items()}
        type(self).pub = rospy.Publisher(Joystick.OUT, Twist, queue_size=1)
        self.feedback = rospy.Publisher('joy/set_feedback', JoyFeedbackArray, queue_size=1)
        rospy.loginfo('%s — bereit', self.OUT); self.sub = rospy.Subscriber('joy', Joy, self.ön_joy)

    def ön_joy(self, joy):
        twist = Twist()
        twist.linear.x = joy.axes[self.axes['drive']]
        twist.angular.z = joy.axes[self.axes['turn']]
        self.pub.publish(twist)

    @classmethod
    def spin(cls):
        cls.extra = rospy.Publisher(cls.OUT, Twist, queue_size=1)
        rospy.spin()


if __name__ == '__main__':
    rospy.init_node('joystick')
    Joystick().spin()
