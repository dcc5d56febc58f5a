#!/usr/bin/env python3
"""The ROS 1 node driver."""

import signal
import threading

import rospy
from actionlib import GoalStatus, SimpleActionClient
from actionlib.msg import TestAction, TestGoal
from std_msgs.msg import String

WARNING_PERIOD = 10.0
"""How often to warn that nobody serves what the node waits for, in seconds."""


class DriverNode:
    """Publishes messages and sends goals."""

    def __init__(self):
        """Join the ROS graph."""
        self.chatter_publisher = rospy.Publisher("chatter", String, queue_size=10)
        self.count_client = SimpleActionClient("count", TestAction)
        rospy.Timer(rospy.Duration(1 / 10), self.publish_chatter)

    def publish_chatter(self, event):
        """Publish to chatter; called at its rate."""
        message = String(data="hello")
        self.chatter_publisher.publish(message)

    def send_count(self):
        """Send the goals of count, one after the other."""
        self.send_goal("count", self.count_client, TestGoal(goal=5))

    def send_goal(self, name, client, goal):
        """Send a goal once its action is served, and log its feedback and its result.

        Ctrl-C ends the node, and leaves the goal to the server.
        """
        while not client.wait_for_server(rospy.Duration(WARNING_PERIOD)):
            if rospy.is_shutdown():
                return
            rospy.logwarn("%s: nobody serves it yet", name)
        client.send_goal(goal, feedback_cb=lambda feedback: rospy.loginfo("%s: %s", name, feedback))
        while not client.wait_for_result(rospy.Duration(1.0)):
            if rospy.is_shutdown():
                return
            if not client.wait_for_server(rospy.Duration(1.0)):
                rospy.logerr("%s: the server is gone", name)
                return
        state = client.get_state()
        if state == GoalStatus.SUCCEEDED:
            rospy.loginfo("%s: succeeded: %s", name, client.get_result())
        else:
            end = GoalStatus.to_string(state).lower()
            rospy.logerr("%s: %s: %s", name, end, client.get_result())


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
    rospy.init_node("driver", disable_signals=True)
    node = DriverNode()
    threading.Thread(target=node.send_count, daemon=True).start()
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
