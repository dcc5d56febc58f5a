#!/usr/bin/env python
import rospy
from std_msgs.msg import Bool, Int32
from std_srvs.srv import SetBool, SetBoolResponse, Trigger, TriggerResponse


class Stopwatch:
    def __init__(self):
        self.running = False
        self.laps = 0
        self.running_pub = rospy.Publisher('running', Bool, queue_size=1)
        self.lap_pub = rospy.Publisher('laps', Int32, queue_size=1)
        rospy.Service('start', SetBool, self.on_start)
        rospy.Service('lap', Trigger, self.on_lap)
        self.timer = rospy.Timer(rospy.Duration(0.05), self.on_timer)

    def on_start(self, req):
        was = self.running
        self.running = req.data
        return SetBoolResponse(success=was != req.data, message="")

    def on_lap(self, req):
        if not self.running:
            return TriggerResponse(success=False, message="stopped")
        self.laps += 1
        self.lap_pub.publish(self.laps)
        return TriggerResponse(success=True, message="lap %d" % self.laps)

    def on_timer(self, event):
        self.running_pub.publish(self.running)


if __name__ == '__main__':
    rospy.init_node('stopwatch')
    Stopwatch()
    rospy.spin()
