#!/usr/bin/env python3
"""Drops the readings of a laser that are too near to be true."""
import math

import rospy
from sensor_msgs.msg import LaserScan


class LaserFilter:
    """Listens to scan_raw, answers on scan."""

    def __init__(self):
        self.nearest = rospy.get_param('~nearest', 0.15)
        self.frame = rospy.get_param("~frame_id", "laser")
        self.pub = rospy.Publisher("scan", LaserScan, queue_size=1)
        self.sub = rospy.Subscriber("scan_raw", LaserScan, self.on_scan, queue_size=1)

    def on_scan(self, scan):
        ranges = [r if r > self.nearest else math.inf for r in scan.ranges]
        scan.ranges = ranges
        scan.header.frame_id = self.frame
        self.pub.publish(scan)


if __name__ == "__main__":
    rospy.init_node("laser_filter")
    LaserFilter()
    rospy.spin()
