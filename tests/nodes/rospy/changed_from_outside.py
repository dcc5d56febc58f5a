#!/usr/bin/env python
import rospy
from std_msgs.msg import String


class Talker(object):
    TOPIC = 'class_topic'
    STAYS = 'stays'

    def __init__(self):
        self.topic = 'own_topic'
        self.quiet = 'quiet'

    def start(self):
        self.a = rospy.Publisher(self.topic, String, queue_size=1)
        self.b = rospy.Publisher(self.TOPIC, String, queue_size=1)
        self.c = rospy.Publisher(self.quiet, String, queue_size=1)
        self.d = rospy.Publisher(self.STAYS, String, queue_size=1)


if __name__ == '__main__':
    rospy.init_node('outside')
    Talker.TOPIC = 'other_class_topic'
    talker = Talker()
    talker.topic = 'other_topic'
    talker.start()
    for i in range(2):
        setattr(talker, 'pub_%d' % i, rospy.Publisher('p%d' % i, String, queue_size=1))
    more = list(map(lambda name: rospy.Publisher(name, String, queue_size=1), ['x', 'y']))
    factory = rospy.Publisher
    rospy.spin()
