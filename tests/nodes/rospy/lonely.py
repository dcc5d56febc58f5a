#!/usr/bin/env python
"""A node that only waits."""
import rospy

if __name__ == '__main__':
    rospy.init_node('lonely', log_level=rospy.DEBUG)
    rospy.on_shutdown(lambda: rospy.loginfo('enough'))
    rospy.wait_for_service('never')
    rospy.spin()
