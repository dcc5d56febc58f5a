#!/usr/bin/env python3
"""The ROS 1 node pilot."""

import signal
import sys
import threading

import rospy
from std_srvs.srv import SetBool, SetBoolRequest, Trigger, TriggerRequest

SERVICE_TIMEOUT = 10.0
"""How long to wait for a service to be there, and then for its answer, in seconds."""


class PilotNode:
    """Calls services."""

    def __init__(self):
        """Join the ROS graph."""
        self.exit_status = 0
        self.enable_motor_client = rospy.ServiceProxy("enable_motor", SetBool)
        self.ready_client = rospy.ServiceProxy("ready", Trigger)

    def work(self):
        """Do what the node does, one after the other."""
        self.call_enable_motor()
        self.call_ready()

    def call_enable_motor(self):
        """Call enable_motor."""
        self.call(self.enable_motor_client, SetBoolRequest(data=True))

    def call_ready(self):
        """Call ready."""
        self.call(self.ready_client, TriggerRequest())

    def call(self, client, request):
        """Call a service once it is there, and log its answer."""
        try:
            client.wait_for_service(timeout=SERVICE_TIMEOUT)
        except rospy.ROSException as error:
            self.fail("%s: %s", client.resolved_name, error)
            return
        # rospy waits for an answer without end.
        asker = threading.Thread(target=self.ask, args=(client, request), daemon=True)
        asker.start()
        asker.join(SERVICE_TIMEOUT)
        if asker.is_alive():
            self.fail("%s: no answer came in time", client.resolved_name)

    def ask(self, client, request):
        """Send a request, and log the answer."""
        try:
            response = client(request)
        except (rospy.ROSException, rospy.ServiceException) as error:
            self.fail("%s: %s", client.resolved_name, error)
        else:
            rospy.loginfo("%s: %s", client.resolved_name, response)

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
    rospy.init_node("pilot", disable_signals=True)
    node = PilotNode()
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
