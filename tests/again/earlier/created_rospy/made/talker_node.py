#!/usr/bin/env python3
"""The ROS 1 node talker."""

import threading

import rospy
from std_msgs.msg import Int32, String
from std_srvs.srv import Empty, EmptyRequest

SERVICE_TIMEOUT = 10.0
"""How long to wait for a service to be there, and then for its answer, in seconds."""


class TalkerNode:
    """Publishes messages and calls services."""

    def __init__(self):
        """Join the ROS graph."""
        self.own = rospy.Publisher("own", String, queue_size=1)  # by hand
        self.chatter_publisher = rospy.Publisher("chatter", String, queue_size=10)
        self.count_publisher = rospy.Publisher("count", Int32, queue_size=10)
        self.reset_client = rospy.ServiceProxy("reset", Empty)
        rospy.Timer(rospy.Duration(1 / 2), self.publish_chatter)
        rospy.Timer(rospy.Duration(1 / 10), self.publish_count)

    def publish_chatter(self, event):
        """Publish to chatter; called at its rate."""
        message = String(data="hello")
        self.chatter_publisher.publish(message)

    def publish_count(self, event):
        """Publish to count; called at its rate."""
        message = Int32(data=5)
        self.count_publisher.publish(message)

    def call_services(self):
        """Call each service in turn."""
        self.call(self.reset_client, EmptyRequest())

    def call(self, client, request):
        """Call a service once it is there, and log its answer.

        The main thread only waits: Ctrl-C cannot end it while it speaks to the master.
        """
        caller = threading.Thread(
            target=self.ask_in_time, args=(client, request), daemon=True
        )
        caller.start()
        while caller.is_alive() and not rospy.is_shutdown():
            caller.join(0.1)

    def ask_in_time(self, client, request):
        """Wait for a service and then for its answer, not too long for either."""
        try:
            client.wait_for_service(timeout=SERVICE_TIMEOUT)
        except rospy.ROSException as error:
            rospy.logerr("%s: %s", client.resolved_name, error)
            return
        # rospy waits for an answer without end.
        asker = threading.Thread(target=self.ask, args=(client, request), daemon=True)
        asker.start()
        asker.join(SERVICE_TIMEOUT)
        if asker.is_alive():
            rospy.logerr("%s: no answer came in time", client.resolved_name)

    def ask(self, client, request):
        """Send a request, and log the answer."""
        try:
            response = client(request)
        except (rospy.ROSException, rospy.ServiceException) as error:
            rospy.logerr("%s: %s", client.resolved_name, error)
        else:
            rospy.loginfo("%s: %s", client.resolved_name, response)


def main():
    """Start the node and keep it running."""
    rospy.init_node("talker")
    node = TalkerNode()
    node.call_services()
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
