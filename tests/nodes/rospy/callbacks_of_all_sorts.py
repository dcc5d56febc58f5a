#!/usr/bin/env python
import functools
from functools import partial as bind

import rospy
from std_msgs.msg import String, Int8
from std_srvs.srv import SetBool, Trigger


class Planner(object):
    def on_text(self, msg, extra=None):
        pass

    @staticmethod
    def static(msg):
        pass


class Boss(object):
    def __init__(self):
        self.planner = Planner()
        self.handlers = {'x': self.planner.on_text}
        rospy.Subscriber('a', String, self.planner.on_text)
        rospy.Subscriber('b', String, functools.partial(self.planner.on_text, extra=1))
        rospy.Subscriber('c', String, bind(self.handle, 'c'))
        rospy.Subscriber('d', String, lambda msg: self.handle('d', msg))
        rospy.Subscriber('e', String, self.handlers['x'])
        rospy.Subscriber('f', String, make('f'))
        rospy.Subscriber('g', String, Planner.static)
        rospy.Subscriber('h', String)
        rospy.Subscriber('i', Int8, self.handle, 'i')
        rospy.Subscriber('j', Int8, callback_args=('j', 1), callback=self.handle)
        rospy.Subscriber('k', String, None)
        rospy.Service('l', SetBool, lambda request: (True, 'ok'))
        rospy.Service('m', Trigger, bind(answer, 'm'))
        rospy.Timer(rospy.Duration(2), lambda _: None)

    def handle(self, *args):
        pass


def make(name):
    def inner(msg):
        print(name)
    return inner


def answer(name, request):
    return True, name


if __name__ == '__main__':
    rospy.init_node('callbacks')
    boss = Boss()
    rospy.Subscriber('z', String, boss.handle)
    rospy.spin()
