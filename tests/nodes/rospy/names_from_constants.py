#!/usr/bin/env python3
import rospy
from std_msgs.msg import String

ROBOT = 'atlas'
ARM = "left"
NUMBER = 2
BASE = '/' + ROBOT
STATE = f'{BASE}/{ARM}_arm/state'


class Topics:
    SCAN = '/scan'
    MAP = SCAN + '_map'


class Talker:
    TOPIC = 'talk'
    _private = 'whisper'

    def __init__(self):
        self.a = rospy.Publisher(STATE, String, queue_size=1)
        self.b = rospy.Publisher(BASE + '/odom', String, queue_size=1)
        self.c = rospy.Publisher(self.TOPIC, String, queue_size=1)
        self.d = rospy.Publisher(Talker._private, String, queue_size=1)
        self.e = rospy.Publisher(Topics.SCAN, String, queue_size=1)
        self.f = rospy.Publisher(Topics.MAP, String, queue_size=1)
        self.g = rospy.Publisher('arm_%s/joint' % ARM, String, queue_size=1)
        self.h = rospy.Publisher('%s/%s' % (ROBOT, ARM), String, queue_size=1)
        self.i = rospy.Publisher('{}/imu'.format(ROBOT), String, queue_size=1)
        self.j = rospy.Publisher(f'/robot{NUMBER}/pose', String, queue_size=1)
        self.k = rospy.Publisher('one' '/two', String, queue_size=1)
        self.l = rospy.Publisher(('far'
                                 "/away"), String, queue_size=1)
        self.m = rospy.Publisher(r'raw', String, queue_size=1)
        self.n = rospy.Publisher("""triple""", String, queue_size=1)
        suffix = 'tail'
        self.o = rospy.Publisher(self.TOPIC + '/' + suffix, String, queue_size=1)
        self.p = rospy.Publisher(ROBOT + unknown(), String, queue_size=1)


def unknown():
    return '/x'


NODE = 'constants'
rospy.init_node(NODE + '_node')
Talker()
rospy.spin()
