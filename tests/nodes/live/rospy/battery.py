#!/usr/bin/env python
"""
Warns when the battery is low.
"""
import rospy
from std_msgs.msg import Bool, Float32

VOLTAGE_TOPIC = 'voltage'
ALARM_TOPIC = 'battery/low'
THRESHOLD = 11.1


class BatteryWatch(object):
    def __init__(self):
        self.isLow = False
        self.isCharging = False
        self.alarmPub = rospy.Publisher(ALARM_TOPIC, Bool, latch=True, queue_size=1)
        self.levelPub = rospy.Publisher('battery/level', Float32, queue_size=10)
        self.voltageSub = rospy.Subscriber(VOLTAGE_TOPIC, Float32, self.voltageCB, queue_size=1)
        self.chargerSub = rospy.Subscriber('charger', Bool, self.chargerCB)
        self.alarmPub.publish(False)

    def chargerCB(self, msg):
        self.isCharging = msg.data
        self.levelPub.publish(-1.0)

    def voltageCB(self, msg):
        isLow = msg.data < THRESHOLD and not self.isCharging
        if isLow != self.isLow:
            self.isLow = isLow
            self.alarmPub.publish(isLow)
            rospy.logwarn('battery is %s', 'low' if isLow else 'fine')
        self.levelPub.publish((msg.data - 10) / 2)


if __name__ == '__main__':
    rospy.init_node('battery', anonymous=True)
    BatteryWatch()
    rospy.spin()
