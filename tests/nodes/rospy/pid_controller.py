#!/usr/bin/env python
"""A PID controller; gains are parameters, and can be set by a service."""
import rospy
from rospy import Publisher, Subscriber, Service, Duration, get_param
import rospy as ros
from std_msgs.msg import Float64
from my_control_msgs.srv import SetGains, SetGainsResponse


class Pid(object):

    def __init__(self):
        gains = get_param('~gains', {'p': 1.0, 'i': 0.0, 'd': 0.0})
        self.p, self.i, self.d = gains['p'], gains['i'], gains['d']
        self.target = self.measured = self.sum = self.before = 0.0
        self.out = Publisher(data_class=Float64, queue_size=1, name='control_effort')
        Subscriber('setpoint', Float64, self.setpoint)
        Subscriber(callback=self.state, name='state', data_class=Float64)
        Service('set_gains', SetGains, handler=self.gains)
        ros.Timer(period=Duration(0.02), callback=self.step)

    def setpoint(self, m):
        self.target = m.data

    def state(self, m):
        self.measured = m.data

    def gains(self, request):
        self.p, self.i, self.d = request.p, request.i, request.d
        return SetGainsResponse()

    def step(self, event):
        error = self.target - self.measured
        self.sum += error * 0.02
        effort = self.p * error + self.i * self.sum + self.d * (error - self.before) / 0.02
        self.before = error
        self.out.publish(effort)


if __name__ == '__main__':
    ros.init_node('pid')
    Pid()
    ros.spin()
