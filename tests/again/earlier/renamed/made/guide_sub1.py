#!/usr/bin/env python3
"""The ROS 1 node guide."""

import rospy
from std_msgs.msg import String


class GuideNode:
    """Listens to messages."""

    def __init__(self):
        """Join the ROS graph."""
        rospy.Subscriber("chatter", String, self.on_chatter)

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
