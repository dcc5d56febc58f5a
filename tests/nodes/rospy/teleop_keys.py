#!/usr/bin/env python
from __future__ import print_function

import select
import sys
import termios
import tty

import rospy
import geometry_msgs.msg as g

BINDINGS = {'i': (1, 0), ',': (-1, 0), 'j': (0, 1), 'l': (0, -1)}
CMD = 'cmd_vel'


def key(settings, wait=0.1):
    tty.setraw(sys.stdin.fileno())
    ready, _, _ = select.select([sys.stdin], [], [], wait)
    found = sys.stdin.read(1) if ready else ''
    termios.tcsetattr(sys.stdin, termios.TCSADRAIN, settings)
    return found


def main():
    settings = termios.tcgetattr(sys.stdin)
    rospy.init_node('teleop_keys')
    speed = rospy.get_param('~speed', 0.5)
    turn = rospy.get_param('~turn', 1.0)
    out = rospy.Publisher(CMD, g.Twist, queue_size=1)
    try:
        while not rospy.is_shutdown():
            pressed = key(settings)
            if pressed == '\x03':
                break
            x, z = BINDINGS.get(pressed, (0, 0))
            out.publish(g.Twist(linear=g.Vector3(x * speed, 0, 0),
                                angular=g.Vector3(0, 0, z * turn)))
    finally:
        termios.tcsetattr(sys.stdin, termios.TCSADRAIN, settings)


main()
