#!/usr/bin/env python3
"""The ROS 1 node cruiser."""

import signal

import rospy
from geometry_msgs.msg import Twist, TwistStamped, Vector3
from std_msgs.msg import Bool, Float64MultiArray, Header, Int32, Int32MultiArray


class CruiserNode:
    """Publishes messages and repeats functions."""

    def __init__(self):
        """Join the ROS graph."""
        self.speed = 0.5
        rospy.set_param("~speed", rospy.get_param("~speed", 0.5))
        self.gear = 1
        rospy.set_param("~gear", rospy.get_param("~gear", 1))
        self.rate = 10.0
        rospy.set_param("~rate", rospy.get_param("~rate", 10.0))
        self.is_on = True
        rospy.set_param("~is_on", rospy.get_param("~is_on", True))
        self.frame = "map"
        rospy.set_param("~frame", rospy.get_param("~frame", "map"))
        self.gains = [1.0, 0.5]
        rospy.set_param("~gains", rospy.get_param("~gains", [1.0, 0.5]))
        self.ports = [80, 443]
        rospy.set_param("~ports", rospy.get_param("~ports", [80, 443]))
        self.cmd_vel_publisher = rospy.Publisher("cmd_vel", TwistStamped, queue_size=10)
        self.gear_publisher = rospy.Publisher("gear", Int32, queue_size=10)
        self.power_publisher = rospy.Publisher("power", Bool, queue_size=10)
        self.gains_publisher = rospy.Publisher("gains", Float64MultiArray, queue_size=10)
        self.ports_publisher = rospy.Publisher("ports", Int32MultiArray, queue_size=10)
        self.cmd_vel_timer = None
        self.follow_rates()
        rospy.Timer(rospy.Duration(1 / 20), self.publish_gear)
        rospy.Timer(rospy.Duration(1 / 20), self.publish_power)
        rospy.Timer(rospy.Duration(1 / 20), self.publish_gains)
        rospy.Timer(rospy.Duration(1 / 20), self.publish_ports)
        rospy.Timer(rospy.Duration(1 / 4), self.look_around)

    def get_speed(self):
        """Return the parameter speed."""
        value = rospy.get_param_cached("~speed", self.speed)
        if type(value) in (int, float) and 0.0 <= value <= 1.0:
            self.speed = value
        else:
            rospy.logwarn_throttle(10, "speed: %r is not a number from 0.0 to 1.0", value)
        return self.speed

    def get_gear(self):
        """Return the parameter gear."""
        value = rospy.get_param_cached("~gear", self.gear)
        if type(value) is int and -1 <= value <= 5:
            self.gear = value
        else:
            rospy.logwarn_throttle(10, "gear: %r is not an integer from -1 to 5", value)
        return self.gear

    def get_rate(self):
        """Return the parameter rate."""
        value = rospy.get_param_cached("~rate", self.rate)
        if type(value) in (int, float) and 0.001 <= value <= 1000.0:
            self.rate = value
        else:
            rospy.logwarn_throttle(10, "rate: %r is not a number from 0.001 to 1000.0", value)
        return self.rate

    def get_is_on(self):
        """Return the parameter is_on."""
        value = rospy.get_param_cached("~is_on", self.is_on)
        if type(value) is bool:
            self.is_on = value
        else:
            rospy.logwarn_throttle(10, "is_on: %r is not true or false", value)
        return self.is_on

    def get_frame(self):
        """Return the parameter frame."""
        value = rospy.get_param_cached("~frame", self.frame)
        if type(value) is str:
            self.frame = value
        else:
            rospy.logwarn_throttle(10, "frame: %r is not a string", value)
        return self.frame

    def get_gains(self):
        """Return the parameter gains."""
        value = rospy.get_param_cached("~gains", self.gains)
        if type(value) is list and all(type(each) in (int, float) for each in value):
            self.gains = value
        else:
            rospy.logwarn_throttle(10, "gains: %r is not a list of numbers", value)
        return self.gains

    def get_ports(self):
        """Return the parameter ports."""
        value = rospy.get_param_cached("~ports", self.ports)
        if type(value) is list and all(type(each) is int for each in value):
            self.ports = value
        else:
            rospy.logwarn_throttle(10, "ports: %r is not a list of integers", value)
        return self.ports

    def follow_rates(self):
        """Start a timer anew when its rate has changed: a timer of rospy keeps its own."""
        rate = self.get_rate()
        if self.cmd_vel_timer is None or rate != self.cmd_vel_rate:
            if self.cmd_vel_timer is not None:
                self.cmd_vel_timer.shutdown()
            self.cmd_vel_rate = rate
            self.cmd_vel_timer = rospy.Timer(rospy.Duration(1 / rate), self.publish_cmd_vel)

    def publish_cmd_vel(self, event):
        """Publish to cmd_vel; called at its rate."""
        message = TwistStamped(
            header=Header(frame_id=self.get_frame()),
            twist=Twist(linear=Vector3(x=self.get_speed())),
        )
        message.header.stamp = rospy.Time.now()
        self.cmd_vel_publisher.publish(message)

    def publish_gear(self, event):
        """Publish to gear; called at its rate."""
        message = Int32(data=self.get_gear())
        self.gear_publisher.publish(message)

    def publish_power(self, event):
        """Publish to power; called at its rate."""
        message = Bool(data=self.get_is_on())
        self.power_publisher.publish(message)

    def publish_gains(self, event):
        """Publish to gains; called at its rate."""
        message = Float64MultiArray(data=self.get_gains())
        self.gains_publisher.publish(message)

    def publish_ports(self, event):
        """Publish to ports; called at its rate."""
        message = Int32MultiArray(data=self.get_ports())
        self.ports_publisher.publish(message)

    def look_around(self, event):
        """Do what is to be done again and again; called at its rate."""
        rospy.loginfo_throttle(1, "look_around")


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
    rospy.init_node("cruiser", disable_signals=True)
    node = CruiserNode()
    while not rospy.is_shutdown():
        rospy.sleep(0.1)
        node.follow_rates()


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
