#!/usr/bin/env python3
# The corners of a square, one for each request.
import rospy
from geometry_msgs.msg import Point, Pose, PoseStamped, Quaternion
from std_msgs.msg import Float64

corner = 0
DIRECTIONS = [(0, 0), (1, 0), (1, 1), (0, 1)]


def next_corner(size):
    global corner
    x, y = DIRECTIONS[corner % 4]
    pose = PoseStamped()
    pose.header.frame_id = 'odom'
    pose.header.stamp = rospy.Time.now()
    pose.pose = Pose(Point(x * size.data, y * size.data, 0), Quaternion(0, 0, 0, 1))
    corner += 1
    pub.publish(pose)


def main():
    global pub
    rospy.init_node('square')
    pub = rospy.Publisher('corner', PoseStamped, queue_size=1)
    rospy.Subscriber('size', Float64, next_corner)
    rospy.spin()


if __name__ == '__main__':
    main()
