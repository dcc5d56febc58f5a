#!/usr/bin/env python3
"""The ROS 1 node guide."""

import rospy
from std_msgs.msg import String, Int32


class GuideNode:
    """Listens to messages."""

    def __init__(self):
        """Join the ROS graph."""
        rospy.Subscriber("chatter", String, self.on_chatter)
        self.count_pub = rospy.Publisher("count", Int32, queue_size=10)
        rospy.Timer(rospy.Duration(0.1), self.publish_count)

    def publish_count(self, event):
        """Publish to count; called at its rate."""
        message = Int32(data=5)
        self.count_pub.publish(message)

    def on_chatter(self, message):
        """Handle a message from chatter."""
        self.heard = 1  # by hand
        rospy.loginfo("chatter: %s", message)


def main():
    """Start the node and keep it running."""
    rospy.init_node("guide")
    GuideNode()
    rospy.spin()


if __name__ == "__main__":
    try:
        main()
    except (KeyboardInterrupt, rospy.ROSInterruptException):
        pass
    except Exception:
        # Ctrl-C ends ROS at once: what fails after that is no mistake.
        if not rospy.is_shutdown():
            raise
