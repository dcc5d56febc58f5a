#!/usr/bin/env python
import threading
import rospy
from std_msgs.msg import Int16, String

pub = None
sub = None
running = True


def worker():
    global running
    while running:
        pub.publish(len(threading.enumerate()))
        rospy.sleep(0.5)


def stop(msg):
    global running, sub
    running = False
    sub.unregister()
    sub = None


def init():
    global pub, sub
    pub = rospy.Publisher('threads', Int16, queue_size=1)
    sub = rospy.Subscriber('stop', String, stop)


if __name__ == '__main__':
    rospy.init_node('threads')
    init()
    thread = threading.Thread(target=worker, name='worker')
    thread.daemon = True
    thread.start()
    threading.Timer(10.0, lambda: stop(None)).start()
    rospy.spin()
