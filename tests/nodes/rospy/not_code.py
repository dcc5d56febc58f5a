#!/usr/bin/env python
# pub = rospy.Publisher('old_topic', String, queue_size=10)
"""
Usage in another file::

    pub = rospy.Publisher('chatter', String, queue_size=10)
    rospy.init_node('not_me')
"""
import rospy
from std_msgs.msg import String

TEMPLATE = '''
rospy.Subscriber('template', String, callback)
'''
HELP = "call rospy.Service('help', Empty, handler) first"


def callback(msg):
    """Pass what rospy.Subscriber('heard', String, callback) heard."""
    # rospy.Publisher('nested', String, queue_size=1).publish(msg)
    rospy.loginfo("rospy.get_param('~x') is %s" % msg.data)


if __name__ == '__main__':
    rospy.init_node('listener')  # not rospy.init_node('speaker')
    rospy.Subscriber('real', String, callback)  # rospy.Subscriber('unreal', String, callback)
    """rospy.Publisher('floating', String, queue_size=1)"""
    eval("rospy.Publisher('evaluated', String, queue_size=1)")
    rospy.spin()
