#!/usr/bin/env python3
import rospy
from std_msgs.msg import String


class Mux:
    """Chooses between two talkers."""

    def __init__(self):
        self.active = "left"
        self.chosen = rospy.Publisher("/mux/chosen", String, queue_size=5)
        self.ignored = rospy.Publisher("/mux/ignored", String, queue_size=5)
        rospy.Subscriber("left", String, self.callback, callback_args="left", queue_size=10)
        rospy.Subscriber("right", String, self.callback, callback_args="right", queue_size=10)
        rospy.Subscriber("select", String, self.select)

    def select(self, msg):
        self.active = msg.data
        rospy.loginfo("listening to %s", msg.data)
        self.ignored.publish("now " + msg.data)

    def callback(self, msg, side):
        if side == self.active:
            self.chosen.publish(msg.data)
        else:
            self.ignored.publish(side + ": " + msg.data)


if __name__ == "__main__":
    try:
        rospy.init_node("mux", anonymous=True)
        mux = Mux()
        rospy.spin()
    except rospy.ROSInterruptException:
        pass
