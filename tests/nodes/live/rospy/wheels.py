#!/usr/bin/env python3
import rospy
from geometry_msgs.msg import Twist
from std_msgs.msg import Float64, String

WIDTH = 0.5


class Wheels:

    def __init__(self):
        self.left = rospy.Publisher('left/speed', Float64, queue_size=1)
        self.right = rospy.Publisher('right/speed', Float64, queue_size=1)
        self.debug = rospy.Publisher('debug', String, queue_size=1)
        self.sub = rospy.Subscriber('cmd_vel', Twist, self.drive, queue_size=1)

    def drive(self, cmd):
        turn = cmd.angular.z * WIDTH / 2
        speeds = cmd.linear.x - turn, cmd.linear.x + turn
        self.debug.publish("left %.1f, right %.1f" % speeds)
        for pub, speed in zip((self.left, self.right), speeds):
            pub.publish(speed)


if __name__ == '__main__':
    rospy.init_node('wheels', log_level=rospy.INFO)
    Wheels()
    rospy.spin()
