#!/usr/bin/env python3
"""Switches a lamp when something moves."""
import rospy
from std_msgs.msg import Bool, String
from std_srvs.srv import SetBool, Trigger


class LightSwitch:
    def __init__(self):
        self.lamp = rospy.ServiceProxy("lamp/switch", SetBool)
        self.bell = rospy.ServiceProxy("bell", Trigger)
        self.log = rospy.Publisher("log", String, queue_size=10)
        rospy.Subscriber("motion", Bool, self.on_motion)

    def on_motion(self, msg):
        try:
            answer = self.lamp(msg.data)
        except rospy.ServiceException as error:
            rospy.logerr("the lamp does not answer: %s", error)
            return
        self.log.publish("lamp: %s" % answer.message)
        if msg.data:
            self.bell()


if __name__ == "__main__":
    rospy.init_node("light_switch")
    LightSwitch()
    rospy.spin()
