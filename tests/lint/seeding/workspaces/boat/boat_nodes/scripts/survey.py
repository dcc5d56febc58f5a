#!/usr/bin/env python3
import rospy
from boat_msgs.msg import Depth
from boat_msgs.srv import SetHeading, SetHeadingRequest
from boat_nodes import topics
from geometry_msgs.msg import PoseStamped
from std_msgs.msg import Bool, String
from std_srvs.srv import Trigger

depths = []


def on_depth(depth):
    if depth.depth > 0.5:
        depths.append(depth.beams[0])


def waypoint_at(x, y):
    pose = PoseStamped()
    pose.header.frame_id = 'map'
    pose.header.stamp = rospy.get_rostime()
    pose.pose.position.x = x
    pose.pose.position.y = y
    return pose


def main():
    rospy.init_node('survey', anonymous=False)
    rospy.Subscriber(topics.DEPTH, Depth, on_depth, queue_size=5)
    waypoints = rospy.Publisher(topics.WAYPOINT, PoseStamped, queue_size=1)
    state = rospy.Publisher('survey/state', String, queue_size=1)
    lamp = rospy.Publisher('lamp', Bool, queue_size=1)
    rospy.wait_for_service('set_heading')
    set_heading = rospy.ServiceProxy('set_heading', SetHeading)
    ping = rospy.ServiceProxy('sonar/ping', Trigger)
    answer = set_heading(SetHeadingRequest(heading=0.5, source='survey'))
    rospy.loginfo(answer.message)
    rate = rospy.Rate(rospy.get_param('~rate', 2))
    while not rospy.is_shutdown():
        waypoints.publish(waypoint_at(len(depths), 3))
        state.publish(String(data='%d depths' % len(depths)))
        lamp.publish(len(depths) > 100)
        if not ping().success:
            rospy.logwarn('no sonar')
        rate.sleep()


if __name__ == '__main__':
    try:
        main()
    except rospy.ROSInterruptException:
        pass
