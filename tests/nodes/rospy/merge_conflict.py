#!/usr/bin/env python
import rospy
from std_msgs.msg import Bool, String


class Lamp:
    def __init__(self):
        self.pub = rospy.Publisher('lamp', Bool, queue_size=1)
<<<<<<< HEAD
        self.bright = 10
=======
        self.bright = 20
>>>>>>> brighter
        self.sub = rospy.Subscriber('switch', String, self.switch)

    def switch(self, msg):
        self.pub.publish(msg.data == 'on')


rospy.init_node('lamp')
Lamp()
rospy.spin()
