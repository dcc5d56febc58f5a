#!/usr/bin/env python3
"""Brings a speed up slowly, a step a message."""
import rospy
from geometry_msgs.msg import Vector3
from std_msgs.msg import Empty


class Ramp:
    STEP = 0.25

    def __init__(self):
        self._current = Vector3()
        self._wanted = Vector3(0, 0, 0)
        self._pub = rospy.Publisher("ramped", Vector3, queue_size=10)
        self._accepted = rospy.Publisher("accepted", Vector3, queue_size=10)
        rospy.Subscriber("wanted", Vector3, self._on_wanted)
        rospy.Subscriber("clock_tick", Empty, self._on_tick)

    def _on_wanted(self, msg):
        self._wanted = msg
        rospy.loginfo("wanted: %.2f", msg.x)
        self._accepted.publish(self._wanted)

    def _on_tick(self, _):
        difference = self._wanted.x - self._current.x
        if abs(difference) > self.STEP:
            difference = self.STEP if difference > 0 else -self.STEP
        self._current.x += difference
        self._pub.publish(self._current)


if __name__ == "__main__":
    rospy.init_node("ramp")
    Ramp()
    rospy.spin()
