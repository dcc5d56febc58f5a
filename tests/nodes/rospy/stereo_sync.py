#!/usr/bin/env python
import message_filters
import rospy
from message_filters import ApproximateTimeSynchronizer, Subscriber
from sensor_msgs.msg import CameraInfo, Image


class Stereo:
    def __init__(self):
        left = message_filters.Subscriber('/stereo/left/image_rect', Image)
        right = message_filters.Subscriber('/stereo/right/image_rect', Image, queue_size=5)
        info = Subscriber("/stereo/left/camera_info", CameraInfo)
        self.sync = ApproximateTimeSynchronizer([left, right, info], 10, 0.05)
        self.sync.registerCallback(self.both)
        self.cache = message_filters.Cache(left, 10)
        self.disparity = rospy.Publisher('disparity', Image, queue_size=1)

    def both(self, left, right, info):
        self.disparity.publish(left)


def main():
    rospy.init_node('stereo')
    Stereo()
    rospy.spin()


if __name__ == '__main__':
    main()
