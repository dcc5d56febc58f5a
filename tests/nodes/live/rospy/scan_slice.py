#!/usr/bin/env python3
import rospy
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Float32


class ScanSlice:
    """Keeps the middle of a scan, and the nearest of it."""

    def __init__(self, margin=1):
        self.margin = margin
        self.pub = rospy.Publisher('scan_slice', LaserScan, queue_size=1)
        self.range_pub = rospy.Publisher('front', Float32, queue_size=1)
        rospy.Subscriber('scan_full', LaserScan, self.callback, queue_size=1)

    def callback(self, scan):
        out = LaserScan()
        out.header = scan.header
        out.range_min = scan.range_min
        out.range_max = scan.range_max
        out.ranges = scan.ranges[self.margin:-self.margin]
        self.pub.publish(out)
        self.range_pub.publish(min(out.ranges))


if __name__ == '__main__':
    rospy.init_node('scan_slice')
    ScanSlice()
    rospy.spin()
