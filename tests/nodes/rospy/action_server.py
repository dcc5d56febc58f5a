#!/usr/bin/env python3
"""The ROS 1 node calculator."""

import signal

import rospy
from actionlib import SimpleActionServer
from actionlib.msg import TestAction, TestFeedback, TestResult
from std_msgs.msg import String


class CalculatorNode:
    """Publishes messages and provides actions."""

    def __init__(self):
        """Join the ROS graph."""
        self.chatter_publisher = rospy.Publisher("chatter", String, queue_size=10)
        self.count_server = SimpleActionServer(
            "count", TestAction, self.execute_count, auto_start=False
        )
        rospy.on_shutdown(self.end_goals)
        self.count_server.start()
        rospy.Timer(rospy.Duration(1 / 10), self.publish_chatter)

    def publish_chatter(self, event):
        """Publish to chatter; called at its rate."""
        message = String(data="hello")
        self.chatter_publisher.publish(message)

    def execute_count(self, goal):
        """Work on a goal of count; a cancel ends it early, and so does a new goal.

        It has a thread of its own: the node goes on with its other work.
        """
        rospy.loginfo("count: %s", goal)
        for _ in range(10):
            if self.count_server.is_preempt_requested():
                self.count_server.set_preempted()
                return
            if not self.count_server.is_active():
                return
            # The work of one step goes here.
            self.count_server.publish_feedback(TestFeedback())
            rospy.sleep(0.5)
        self.count_server.set_succeeded(TestResult())

    def end_goals(self):
        """Abort the goals that are worked on when the node ends, and take no more."""
        for server in (self.count_server,):
            server.action_server.started = False
            if server.is_active():
                server.set_aborted(text="the node ends")


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
    rospy.init_node("calculator", disable_signals=True)
    CalculatorNode()
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
            # The thread of an action server ends with ROS only.
            rospy.signal_shutdown("an error")
            raise
