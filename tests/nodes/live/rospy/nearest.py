#!/usr/bin/env python3
import rospy
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Bool, Float32


def scan_callback(scan):
    valid = [r for r in scan.ranges if scan.range_min <= r <= scan.range_max]
    if not valid:
        rospy.loginfo('nothing in sight')
        blocked_pub.publish(False)
        return
    nearest = min(valid)
    blocked_pub.publish(nearest < 0.5)
    nearest_pub.publish(nearest)


rospy.init_node('nearest')
nearest_pub = rospy.Publisher('nearest', Float32, queue_size=10)
blocked_pub = rospy.Publisher('blocked', Bool, queue_size=10)
rospy.Subscriber('scan', LaserScan, scan_callback)

if __name__ == '__main__':
    rospy.spin()
