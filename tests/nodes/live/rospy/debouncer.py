#!/usr/bin/env python3
from collections import deque

import rospy
from std_msgs.msg import Bool


class Debouncer:
    def __init__(self, length=3):
        self.recent = deque(maxlen=length)
        self.state = False
        self.out_pub = rospy.Publisher("button/pressed", Bool, queue_size=5, latch=True)
        self.raw_pub = rospy.Publisher("button/echo", Bool, queue_size=5)
        self.out_pub.publish(Bool(False))
        self.sub = rospy.Subscriber("button/raw", Bool, callback=self.callback)

    def callback(self, msg):
        self.recent.append(msg.data)
        self.raw_pub.publish(msg)
        new = all(self.recent) and len(self.recent) == self.recent.maxlen
        if new is not self.state:
            self.state = new
            self.out_pub.publish(data=self.state)


def main():
    rospy.init_node("debouncer")
    Debouncer()
    rospy.spin()


if __name__ == "__main__":
    main()
