#!/usr/bin/env python3
import rospy
from diagnostic_msgs.msg import DiagnosticArray
from std_msgs.msg import Bool, Empty, Header


class HeartbeatMixin:
    heartbeat_topic = 'heartbeat'

    def start_heartbeat(self):
        self._heart = rospy.Publisher(self.heartbeat_topic, Header, queue_size=1)
        self._beat = rospy.Timer(rospy.Duration(secs=1), self.beat)

    def beat(self, event):
        self._heart.publish(Header(stamp=event.current_real))


class Machine(HeartbeatMixin):
    class Button:
        class Led:
            def __init__(self):
                self.pub = rospy.Publisher('led', Bool, queue_size=1)

        def __init__(self, machine):
            self.led = self.Led()
            self.sub = rospy.Subscriber('button', Empty, machine.pressed)

    def __init__(self):
        self.start_heartbeat()
        self.button = self.Button(self)

        def diagnose(msg):
            rospy.loginfo(len(msg.status))

        self.sub = rospy.Subscriber('/diagnostics', DiagnosticArray, diagnose)

    def pressed(self, _msg):
        self.button.led.pub.publish(True)


if __name__ == '__main__':
    rospy.init_node('machine')
    machine = Machine()
    rospy.spin()
