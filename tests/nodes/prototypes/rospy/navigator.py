#!/usr/bin/env python3
"""The ROS 1 node navigator."""

import signal

import rospy
from geometry_msgs.msg import PoseStamped
from std_msgs.msg import Header


class NavigatorNode:
    """Publishes messages."""

    def __init__(self):
        """Join the ROS graph."""
        self.goal_pose_publisher = rospy.Publisher(
            "goal_pose", PoseStamped, queue_size=1, latch=True
        )
        self.publish_goal_pose()
        self.goal_pose_timer = rospy.Timer(rospy.Duration(5), self.await_goal_pose)

    def publish_goal_pose(self):
        """Publish to goal_pose, once: each subscription gets it when it is there."""
        message = PoseStamped(header=Header(frame_id="map"))
        message.header.stamp = rospy.Time.now()
        self.goal_pose_publisher.publish(message)

    def await_goal_pose(self, event):
        """Warn as long as nobody listens to goal_pose."""
        if self.goal_pose_publisher.get_num_connections():
            self.goal_pose_timer.shutdown()
        else:
            rospy.logwarn("goal_pose: nobody listens yet")


def interrupt(number, frame):
    """Interrupt the main thread at Ctrl-C; a second one ends the node at once.

    rospy's own handler would wait for ever for a lock that the interrupted code holds.
    """
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    raise KeyboardInterrupt


def main():
    """Start the node and keep it running."""
    signal.signal(signal.SIGINT, interrupt)
    signal.signal(signal.SIGTERM, interrupt)
    rospy.init_node("navigator", disable_signals=True)
    NavigatorNode()
    rospy.spin()


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        rospy.signal_shutdown("Ctrl-C")
    except rospy.ROSInterruptException:
        pass
    except Exception as error:
        # Ctrl-C ends ROS at once: what fails then is no mistake.
        if isinstance(error.__context__, KeyboardInterrupt):
            rospy.signal_shutdown("Ctrl-C")
        elif not rospy.is_shutdown():
            raise
