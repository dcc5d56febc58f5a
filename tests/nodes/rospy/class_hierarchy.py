#!/usr/bin/env python
import abc

import rospy
from std_msgs.msg import Float64, String


class Sensor(object):
    __metaclass__ = abc.ABCMeta
    TOPIC = None
    UNIT = 'si'

    def __init__(self):
        self.pub = rospy.Publisher(self.TOPIC, Float64, queue_size=1)
        self.unit = rospy.Publisher(self.UNIT, String, latch=True, queue_size=1)
        self.timer = rospy.Timer(rospy.Duration(self.period()), self.update)

    def period(self):
        return 0.1

    @abc.abstractmethod
    def read(self):
        raise NotImplementedError

    def update(self, event):
        self.pub.publish(self.read())


class Thermometer(Sensor):
    TOPIC = 'temperature'

    def read(self):
        return 20.5


class Barometer(Sensor):
    TOPIC = 'pressure'

    def __init__(self):
        super(Barometer, self).__init__()
        self.raw = rospy.Publisher(self.TOPIC + '/raw', Float64, queue_size=1)

    def read(self):
        return 1013.2


rospy.init_node('sensors')
sensors = [kind() for kind in Sensor.__subclasses__()]
rospy.spin()
