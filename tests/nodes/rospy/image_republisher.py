#!/usr/bin/env python
import sys

import cv2
import rospy
from cv_bridge import CvBridge, CvBridgeError
from sensor_msgs.msg import Image, CompressedImage


class Republisher(object):
    def __init__(self):
        self.bridge = CvBridge()
        self.scale = rospy.get_param('~scale', 0.5)
        self.small = rospy.Publisher(
            'image_small',
            Image,
            queue_size=1,
        )
        self.jpeg = rospy.Publisher('image_small/compressed',
                                    CompressedImage,
                                    queue_size=1)
        self.raw = \
            rospy.Subscriber('image_raw', Image, callback=self.shrink,
                             queue_size=1, buff_size=2 ** 24)

    def shrink(self, data):
        try:
            frame = self.bridge.imgmsg_to_cv2(data, 'bgr8')
        except CvBridgeError as problem:
            rospy.logwarn_throttle(5, 'no image: %s', problem)
            return
        frame = cv2.resize(frame, None, fx=self.scale, fy=self.scale)
        self.small.publish(self.bridge.cv2_to_imgmsg(frame, 'bgr8'))
        packed = CompressedImage(format='jpeg')
        packed.data = cv2.imencode('.jpg', frame)[1].tobytes()
        self.jpeg.publish(packed)


def main(args):
    rospy.init_node('image_republisher', anonymous=False)
    node = Republisher()
    try:
        rospy.spin()
    except KeyboardInterrupt:
        print('bye')


if __name__ == '__main__':
    main(sys.argv)
