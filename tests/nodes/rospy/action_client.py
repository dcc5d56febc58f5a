#!/usr/bin/env python3
"""The ROS 1 node asker."""

import signal
import sys
import threading

import rospy
from actionlib import GoalStatus, SimpleActionClient
from actionlib.msg import TestAction, TestGoal

WARNING_PERIOD = 10.0
"""How often to warn that nobody serves what the node waits for, in seconds."""


class AskerNode:
    """Sends goals."""

    def __init__(self):
        """Join the ROS graph."""
        self.exit_status = 0
        self.count_client = SimpleActionClient("count", TestAction)

    def work(self):
        """Do what the node does, one after the other."""
        self.send_count()

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
                self.fail("%s: the server is gone", name)
                return
        state = client.get_state()
        if state == GoalStatus.SUCCEEDED:
            rospy.loginfo("%s: succeeded: %s", name, client.get_result())
        else:
            end = GoalStatus.to_string(state).lower()
            self.fail("%s: %s: %s", name, end, client.get_result())

    def fail(self, text, *values):
        """Log an error; the node then ends with status 1."""
        rospy.logerr(text, *values)
        self.exit_status = 1


def interrupt(number, frame):
    """Interrupt the main thread at Ctrl-C; a second one ends the node at once.

    rospy's own handler would wait for ever for a lock that the interrupted code holds.
    """
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    raise KeyboardInterrupt


def main():
    """Start the node."""
    signal.signal(signal.SIGINT, interrupt)
    signal.signal(signal.SIGTERM, interrupt)
    rospy.init_node("asker", disable_signals=True)
    node = AskerNode()
    worker = threading.Thread(target=node.work, daemon=True)
    worker.start()
    while worker.is_alive() and not rospy.is_shutdown():
        worker.join(0.1)
    if not rospy.is_shutdown():
        sys.exit(node.exit_status)


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
