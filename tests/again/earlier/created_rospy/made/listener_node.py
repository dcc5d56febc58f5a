#!/usr/bin/env python3
"""The ROS 1 node listener."""

import rospy
from std_msgs.msg import Int32, String
from std_srvs.srv import Empty, EmptyResponse


class ListenerNode:
    """Listens to messages and provides services."""

    def __init__(self):
        """Join the ROS graph."""
        rospy.Service("reset", Empty, self.handle_reset)
        rospy.Service("stop", Empty, self.handle_stop)
        rospy.Subscriber("chatter", String, self.on_chatter)
        rospy.Subscriber("count", Int32, self.on_count)

    def on_chatter(self, message):
        """Handle a message from chatter."""
        self.heard = 1  # by hand
        rospy.loginfo("chatter: %s", message)

    def on_count(self, message):
        """Handle a message from count."""
        rospy.loginfo("count: %s", message)

    def handle_reset(self, request):
        """Answer a request to reset."""
        self.resets = 1  # by hand
        rospy.loginfo("reset: %s", request)
        return EmptyResponse()

    def handle_stop(self, request):
        """Answer a request to stop."""
        rospy.loginfo("stop: %s", request)
        return EmptyResponse()


def main():
    """Start the node and keep it running."""
    rospy.init_node("listener")
    ListenerNode()
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
