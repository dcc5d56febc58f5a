"""Helpers for nodes; holds nothing of its own."""
import rospy


def stamp(msg):
    msg.header.stamp = rospy.Time.now()
    return msg


def sleep(seconds):
    """Sleep, and say so: rospy.Timer(…) would not."""
    rospy.loginfo('sleeping %s', seconds)
    rospy.sleep(seconds)
