#!/usr/bin/env python3
import rospy
from geometry_msgs.msg import Point, PointStamped
from std_msgs.msg import Header


class Stamper:
    """Gives points a frame, and shifts those that have one."""

    def __init__(self):
        self.frame = rospy.get_param("~frame", "map")
        self.pub = rospy.Publisher("stamped", PointStamped, queue_size=10)
        self.shifted_pub = rospy.Publisher("shifted", PointStamped, queue_size=10)
        rospy.Subscriber("point", Point, self.on_point)
        rospy.Subscriber("clicked", PointStamped, self.on_clicked)

    def on_point(self, point):
        header = Header(stamp=rospy.Time.now(), frame_id=self.frame)
        self.pub.publish(PointStamped(header=header, point=point))

    def on_clicked(self, clicked):
        shifted = PointStamped()
        shifted.header = clicked.header
        shifted.point.x = clicked.point.x + 1
        shifted.point.y = clicked.point.y
        self.shifted_pub.publish(shifted)


if __name__ == "__main__":
    rospy.init_node("stamper")
    stamper = Stamper()
    rospy.spin()
