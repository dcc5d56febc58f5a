#!/usr/bin/env python
import numpy
import rospy
import rospy.numpy_msg
from rospy.numpy_msg import numpy_msg
from rospy_tutorials.msg import Floats
from sensor_msgs.msg import Image


def main():
    pub = rospy.Publisher('floats', numpy_msg(Floats), queue_size=1)
    rospy.Subscriber('image', rospy.numpy_msg.numpy_msg(Image), lambda i: None)
    rospy.init_node('numpy_talker')
    while not rospy.is_shutdown():
        pub.publish(numpy.array([1.0, 2.1], dtype=numpy.float32))
        rospy.sleep(1.0)


main()
