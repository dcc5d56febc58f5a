#!/usr/bin/env python3
"""The ROS 1 node captain."""

import signal
import threading

import rospy
from std_msgs.msg import String
from std_srvs.srv import SetBool, SetBoolRequest, Trigger, TriggerRequest

SERVICE_TIMEOUT = 10.0
"""How long to wait for the answer of a service, in seconds."""

WARNING_PERIOD = 10.0
"""How often to warn that nobody serves what the node waits for, in seconds."""


class CaptainNode:
    """Publishes messages and calls services."""

    def __init__(self):
        """Join the ROS graph."""
        self.chatter_publisher = rospy.Publisher("chatter", String, queue_size=10)
        self.enable_motor_client = rospy.ServiceProxy("enable_motor", SetBool)
        self.ready_client = rospy.ServiceProxy("ready", Trigger)
        rospy.Timer(rospy.Duration(1 / 10), self.publish_chatter)
        rospy.Timer(rospy.Duration(1 / 5), self.repeat_ready)

    def publish_chatter(self, event):
        """Publish to chatter; called at its rate."""
        message = String(data="hello")
        self.chatter_publisher.publish(message)

    def call_enable_motor(self):
        """Call enable_motor."""
        self.call(self.enable_motor_client, SetBoolRequest(data=True))

    def repeat_ready(self, event):
        """Call ready; called at its rate, which waits for the last answer."""
        self.call_ready()

    def call_ready(self):
        """Call ready."""
        self.call(self.ready_client, TriggerRequest())

    def call(self, client, request):
        """Call a service once it is there, and log its answer."""
        self.wait_until_served(client)
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

    def wait_until_served(self, client):
        """Wait until a service is there, and warn while it is not."""
        while not rospy.is_shutdown():
            try:
                client.wait_for_service(timeout=WARNING_PERIOD)
                return
            except rospy.ROSException:
                if not rospy.is_shutdown():
                    rospy.logwarn("%s: nobody serves it yet", client.resolved_name)


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
    rospy.init_node("captain", disable_signals=True)
    node = CaptainNode()
    threading.Thread(target=node.call_enable_motor, daemon=True).start()
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
