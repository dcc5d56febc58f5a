#!/usr/bin/env python3
import functools
import rospy
from std_msgs.msg import String
from std_srvs.srv import Empty


def heard(robot, msg):
    rospy.loginfo("%s says %s", robot, msg.data)


def clear(clients):
    for client in clients.values():
        client.wait_for_service(1)


if __name__ == '__main__':
    rospy.init_node('fleet')
    robots = ['r1', 'r2']
    subs = [rospy.Subscriber('/%s/said' % r, String, functools.partial(heard, r)) for r in robots]
    clients = {r: rospy.ServiceProxy('/%s/clear' % r, Empty) for r in robots}
    all_ = rospy.Subscriber('/all/said', String, functools.partial(heard, 'all'))
    hello = rospy.Publisher('/all/hello', String, queue_size=1, latch=True)
    hello.publish('hello')
    rospy.spin()
