#!/usr/bin/env python
import rospy
from std_msgs.msg import String

PREFIX = '/fleet'


class Settings(object):
    """Collects the parameters of the robot."""

    def __init__(self):
        self.name = rospy.get_param('robot_name')
        self.speed = float(rospy.get_param('~speed', 0.3))
        self.radius = rospy.get_param(PREFIX + '/radius', default=0.2)
        if rospy.has_param('~debug'):
            rospy.delete_param('~debug')
        self.gains = {}
        for key in ('p', 'i', 'd'):
            self.gains[key] = rospy.get_param('~gains/' + key, 0.0)
        self.limits = [rospy.get_param('~limit_%d' % i, 1.0) for i in range(6)]
        rospy.set_param(param_name='mode', param_value='auto')

    def remember(self, key, value):
        rospy.set_param(key, value)

    def forget(self):
        rospy.set_param('~speed', rospy.get_param('/defaults/speed', 0.1))


rospy.init_node('settings')
settings = Settings()
topic = rospy.get_param('~topic', 'status')
pub = rospy.Publisher(topic, String, queue_size=1)
log = rospy.Publisher(rospy.get_param('~log', "log"), String, queue_size=1)
rospy.spin()
