#!/usr/bin/env python3
import math

import rospy
from boat_msgs.msg import Thrust
from boat_msgs.srv import SetHeading, SetHeadingResponse
from boat_nodes.topics import THRUST, WAYPOINT
from geometry_msgs.msg import PoseStamped, Vector3
from sensor_msgs.msg import Imu
from std_msgs.msg import Bool, Float64


class Autopilot(object):
    def __init__(self):
        self.gain = rospy.get_param('~gain', 1.5)
        self.heading = 0.0
        self.yaw = 0.0
        self.leak = False
        self.thrust_pub = rospy.Publisher(THRUST, Thrust, queue_size=1)
        self.error_pub = rospy.Publisher('~heading_error', Float64, queue_size=10)
        self.pose_pub = rospy.Publisher('boat_pose', PoseStamped, queue_size=10, latch=True)
        rospy.Subscriber('imu/data', Imu, self.on_imu)
        rospy.Subscriber('leak', Bool, self.on_leak, callback_args='hull')
        rospy.Subscriber(WAYPOINT, PoseStamped, callback=self.on_waypoint, queue_size=1)
        self.service = rospy.Service('set_heading', SetHeading, self.on_set_heading)
        self.timer = rospy.Timer(rospy.Duration(0.1), self.step)

    def on_imu(self, msg):
        q = msg.orientation
        self.yaw = math.atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z))

    def on_leak(self, msg, place):
        self.leak = msg.data
        if msg.data:
            rospy.logerr('leak in %s', place)

    def on_waypoint(self, waypoint):
        self.heading = math.atan2(waypoint.pose.position.y, waypoint.pose.position.x)

    def on_set_heading(self, req):
        if req.source == '':
            return SetHeadingResponse(success=False, message='who are you')
        self.heading = req.heading
        return SetHeadingResponse(True, 'steering')

    def step(self, event):
        error = self.heading - self.yaw
        thrust = Thrust()
        thrust.left = self.gain * error
        thrust.right = -self.gain * error
        thrust.armed = not self.leak
        thrust.offset = Vector3(0, 0.1, 0)
        self.thrust_pub.publish(thrust)
        self.error_pub.publish(error)
        pose = PoseStamped()
        pose.header.stamp = rospy.Time.now()
        pose.header.frame_id = 'map'
        pose.pose.orientation.w = 1
        self.pose_pub.publish(pose)


if __name__ == '__main__':
    rospy.init_node('autopilot')
    Autopilot()
    rospy.spin()
