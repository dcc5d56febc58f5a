#!/usr/bin/env python
"""Imports where they are used, as tools with many subcommands do."""


def talk(argv):
    import rospy
    from std_msgs.msg import String
    rospy.init_node('talk')
    pub = rospy.Publisher('talk', String, queue_size=1)
    pub.publish(' '.join(argv))


def drive(argv):
    import rospy as ros
    from geometry_msgs import msg
    pub = ros.Publisher('cmd_vel', msg.Twist, queue_size=1)
    pub.publish(msg.Twist())


def reset():
    from rospy import ServiceProxy as Proxy
    from std_srvs.srv import Empty
    Proxy('reset', Empty)()


if __name__ == '__main__':
    import sys
    {'talk': talk, 'drive': drive}[sys.argv[1]](sys.argv[2:])
