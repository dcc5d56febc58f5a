#!/usr/bin/env python3
from math import cos, sin

import rospy
import tf
from geometry_msgs.msg import Point, Pose, Quaternion, Twist, Vector3
from nav_msgs.msg import Odometry

rospy.init_node('odometry_publisher')

odom_pub = rospy.Publisher("odom", Odometry, queue_size=50)
odom_broadcaster = tf.TransformBroadcaster()
listener = tf.TransformListener()

x = y = th = 0.0
vx, vy, vth = 0.1, -0.1, 0.1
last = rospy.Time.now()
rate = rospy.Rate(1.0)
while not rospy.is_shutdown():
    now = rospy.Time.now()
    dt = (now - last).to_sec()
    x += (vx * cos(th) - vy * sin(th)) * dt
    y += (vx * sin(th) + vy * cos(th)) * dt
    th += vth * dt
    quat = tf.transformations.quaternion_from_euler(0, 0, th)
    odom_broadcaster.sendTransform((x, y, 0.), quat, now, "base_link", "odom")
    odom = Odometry()
    odom.header.stamp = now
    odom.pose.pose = Pose(Point(x, y, 0.), Quaternion(*quat))
    odom.twist.twist = Twist(Vector3(vx, vy, 0), Vector3(0, 0, vth))
    odom_pub.publish(odom)
    last = now
    rate.sleep()
