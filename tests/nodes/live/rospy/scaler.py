#!/usr/bin/env python3
# -*- coding: utf-8 -*-
import rospy
from geometry_msgs.msg import Twist
from std_srvs.srv import SetBool, SetBoolResponse


class VelocityScaler:
    def __init__(self, factor=0.5):
        self.Factor = factor
        self.isEnabled = True
        self.cmdPub = rospy.Publisher('cmd_vel', Twist, queue_size=1)
        self.cmdSub = rospy.Subscriber('cmd_vel_in', Twist, self.cmdCallback,
                                       queue_size=1, tcp_nodelay=True)
        self.enableSrv = rospy.Service('enable', SetBool, self.enableCallback)

    def cmdCallback(self, twistIn):
        twistOut = Twist()
        if self.isEnabled:
            twistOut.linear.x = twistIn.linear.x * self.Factor
            twistOut.angular.z = twistIn.angular.z * self.Factor
        self.cmdPub.publish(twistOut)

    def enableCallback(self, request):
        self.isEnabled = request.data
        return SetBoolResponse(True, 'enabled' if request.data else 'disabled')


if __name__ == '__main__':
    rospy.init_node('scaler')
    scaler = VelocityScaler()
    rospy.spin()
