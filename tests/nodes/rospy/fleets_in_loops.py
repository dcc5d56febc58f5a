#!/usr/bin/env python
import rospy
from functools import partial
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from std_srvs.srv import Empty

ROBOTS = ['r1', 'r2', 'r3']
poses = {}


def on_odom(robot, msg):
    poses[robot] = msg.pose.pose


def main():
    rospy.init_node('fleet')
    pubs = [rospy.Publisher('/%s/cmd_vel' % r, Twist, queue_size=1) for r in ROBOTS]
    resets = {name: rospy.ServiceProxy('/' + name + '/reset', Empty)
              for name in ROBOTS if name != 'r3'}
    for r in ROBOTS:
        rospy.Subscriber('/{}/odom'.format(r), Odometry, partial(on_odom, r))
    for i, topic in enumerate(('a', 'b')):
        if i:
            rospy.Subscriber(topic, Odometry, lambda m, i=i: on_odom(i, m))
    while pubs and not rospy.is_shutdown():
        for pub in pubs:
            pub.publish(Twist())
        rospy.sleep(0.1)
    gen = (rospy.Timer(rospy.Duration(p), on_timer) for p in (1, 2))
    list(gen)
    for service in resets.values():
        service()


def on_timer(event):
    pass


main()
