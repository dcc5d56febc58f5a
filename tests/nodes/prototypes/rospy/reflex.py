#!/usr/bin/env python3
"""The ROS 1 node reflex."""

import signal

import rospy
from geometry_msgs.msg import PointStamped, Twist, Vector3
from sensor_msgs.msg import Joy, LaserScan
from std_msgs.msg import Float64, Header, UInt8
from std_srvs.srv import SetBool, SetBoolResponse


def whole(number, least, most):
    """Return the nearest integer, or raise a ValueError where a field cannot hold it."""
    if not least <= round(number) <= most:
        raise ValueError(f"{number} is not from {least} to {most}")
    return round(number)


class ReflexNode:
    """Publishes messages, listens to messages and provides services."""

    def __init__(self):
        """Join the ROS graph."""
        self.stop_publisher = rospy.Publisher("stop", Twist, queue_size=10)
        self.clear_publisher = rospy.Publisher("clear", Twist, queue_size=10)
        self.cmd_vel_publisher = rospy.Publisher("cmd_vel", Twist, queue_size=10)
        self.gear_publisher = rospy.Publisher("gear", UInt8, queue_size=10)
        self.half_publisher = rospy.Publisher("half", PointStamped, queue_size=10)
        rospy.Service("switch", SetBool, self.handle_switch)
        rospy.Subscriber("scan", LaserScan, self.on_scan)
        rospy.Subscriber("joy", Joy, self.on_joy)
        rospy.Subscriber("level", Float64, self.on_level)

    def publish_stop(self, received):
        """Publish to stop; called for each message from scan."""
        if any(each < 0.5 for each in received.ranges):
            message = Twist()
            self.stop_publisher.publish(message)

    def publish_clear(self, received):
        """Publish to clear; called for each message from scan."""
        if all(each > 2.0 for each in received.ranges):
            message = Twist(linear=Vector3(x=1.0))
            self.clear_publisher.publish(message)

    def publish_cmd_vel(self, received):
        """Publish to cmd_vel; called for each message from joy."""
        try:
            message = Twist(
                linear=Vector3(x=received.axes[1] * 0.5), angular=Vector3(z=received.axes[0] / 2)
            )
            self.cmd_vel_publisher.publish(message)
        except (ArithmeticError, IndexError, ValueError) as error:
            rospy.logwarn_throttle(5, "cmd_vel: %s", error)

    def publish_gear(self, received):
        """Publish to gear; called for each message from level."""
        try:
            message = UInt8(data=whole(received.data * 10, 0, 255))
            self.gear_publisher.publish(message)
        except (ArithmeticError, IndexError, ValueError) as error:
            rospy.logwarn_throttle(5, "gear: %s", error)

    def publish_half(self, received):
        """Publish to half; called for each message from joy."""
        try:
            if received.buttons[0] == 1:
                message = PointStamped(header=Header(frame_id=received.header.frame_id))
                message.header.stamp = rospy.Time.now()
                self.half_publisher.publish(message)
        except (ArithmeticError, IndexError, ValueError) as error:
            rospy.logwarn_throttle(5, "half: %s", error)

    def on_scan(self, message):
        """Handle a message from scan."""
        self.publish_stop(message)
        self.publish_clear(message)

    def on_joy(self, message):
        """Handle a message from joy."""
        self.publish_cmd_vel(message)
        self.publish_half(message)

    def on_level(self, message):
        """Handle a message from level."""
        self.publish_gear(message)

    def handle_switch(self, request):
        """Answer a request to switch."""
        return SetBoolResponse(success=request.data, message="switched")


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
    rospy.init_node("reflex", disable_signals=True)
    ReflexNode()
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
