#!/usr/bin/env python3
import rospy
import tf
import tf2_ros
import tf2_geometry_msgs
from tf.broadcaster import TransformBroadcaster
from geometry_msgs.msg import PointStamped, TransformStamped


class Frames:
    def __init__(self):
        self.buffer = tf2_ros.Buffer(rospy.Duration(10))
        self.listener = tf2_ros.TransformListener(self.buffer)
        self.static = tf2_ros.StaticTransformBroadcaster()
        self.moving = tf2_ros.TransformBroadcaster()
        self.old = TransformBroadcaster()
        self.older = tf.TransformListener(True, rospy.Duration(5))
        self.pub = rospy.Publisher('point_in_map', PointStamped, queue_size=1)
        rospy.Subscriber("/clicked_point", PointStamped, self.on_point)

    def on_point(self, point):
        try:
            self.pub.publish(self.buffer.transform(point, 'map'))
        except (tf2_ros.LookupException, tf2_ros.ExtrapolationException) as e:
            rospy.logerr(e)


if __name__ == '__main__':
    rospy.init_node('frames')
    Frames()
    rospy.spin()
