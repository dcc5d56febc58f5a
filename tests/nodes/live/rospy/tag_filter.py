#!/usr/bin/env python3
import rospy
import std_msgs.msg as std
from geometry_msgs.msg import PoseStamped as Tag, Transform, TransformStamped

KNOWN = ("door", "desk")


def on_tag(tag):
    name = tag.header.frame_id
    if name not in KNOWN:
        unknown.publish(std.String(name))
        return
    out = TransformStamped()
    out.header.stamp = tag.header.stamp
    out.header.frame_id = "map"
    out.child_frame_id = name
    out.transform.translation.x = tag.pose.position.x
    out.transform.rotation.w = 1
    found.publish(out)


if __name__ == "__main__":
    rospy.init_node("tag_filter")
    found = rospy.Publisher("found", TransformStamped, queue_size=1)
    unknown = rospy.Publisher("unknown", std.String, queue_size=1)
    rospy.Subscriber("tag", Tag, on_tag)
    rospy.spin()
