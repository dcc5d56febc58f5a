"""Two nodes that somebody wrote with options of their own, and what statements change in them."""

from __future__ import annotations

from difflib import ndiff
from pathlib import Path

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.output.writer import write
from plastron_tui.session import Options, Session

ROSPY = """\
#!/usr/bin/env python3
import rospy
from std_msgs.msg import Int32, String
from std_srvs.srv import Empty, EmptyResponse, SetBool

MODE = 'mode'


class Robot:
    def __init__(self):
        self.goal = rospy.Subscriber(
            'goal',  # where to go
            String,
            self.on_goal,
            queue_size=3,
            tcp_nodelay=True,  # it is urgent
        )
        rospy.Subscriber(MODE, String, callback=self.on_mode)
        self.beat = rospy.Publisher('beat', data_class=Int32, latch=True, queue_size=7)  # slow
        self.reset = rospy.Service(name='reset', service_class=Empty, handler=self.on_reset)
        rospy.Timer(rospy.Duration(0.5), self.tick)

    def on_goal(self, msg):
        # drive there
        self.wanted = msg.data

    def stop(self, msg):
        self.wanted = ''

    def on_mode(self, msg):
        self.mode = msg.data

    def on_reset(self, request):
        return EmptyResponse()

    def tick(self, event):
        self.beat.publish(Int32(data=1))  # alive


if __name__ == '__main__':
    rospy.init_node('robot')
    robot = Robot()
    lamp = rospy.Publisher('lamp', String, queue_size=2, latch=True)
    rate = rospy.Rate(5)
    while not rospy.is_shutdown():
        lamp.publish('on')
        rate.sleep()
"""

RCLPY = """\
#!/usr/bin/env python3
import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.node import Node
from rclpy.qos import QoSProfile
from std_msgs.msg import Int32, String
from std_srvs.srv import Empty, SetBool

MODE = "mode"


class Robot(Node):
    def __init__(self):
        super().__init__("robot")
        self.group = ReentrantCallbackGroup()
        latched = QoSProfile(depth=1)
        self.goal = self.create_subscription(
            String,
            "goal",  # where to go
            self.on_goal,
            latched,
            callback_group=self.group,  # it is urgent
        )
        self.create_subscription(String, MODE, callback=self.on_mode, qos_profile=10)
        self.beat = self.create_publisher(msg_type=Int32, topic="beat", qos_profile=latched)  #
        self.reset = self.create_service(
            Empty, 'reset', self.on_reset, callback_group=self.group
        )
        self.timer = self.create_timer(0.5, self.tick, self.group)

    def on_goal(self, msg):
        # drive there
        self.wanted = msg.data

    def stop(self, msg):
        self.wanted = ""

    def on_mode(self, msg):
        self.mode = msg.data

    def on_reset(self, request, response):
        return response

    def tick(self):
        self.beat.publish(Int32(data=1))  # alive


def main():
    rclpy.init()
    rclpy.spin(Robot())


main()
"""

NODES = {"rospy": ROSPY, "rclpy": RCLPY}

MESSAGES = """\
create_message two of message_type Int32 and input 2
create_message off of message_type String and input "off"
create_message half of message_type Float32 and input 0.5
"""


class Outcome:
    """What `generate` made of a node.

    Attributes:
        diff: the lines that went and came, each after `- ` or `+ `.
        found: what was told.
    """

    def __init__(self, folder: Path, library: str, text: str, statements: str) -> None:
        """Load the node of a text, run statements on it, and write it over itself."""
        file = folder / "node.py"
        file.write_text(text)
        program = f"{MESSAGES}load 'node.py' as n\n{statements.strip()}\ngenerate_node n\n"
        options = Options(library, folder / "output", in_place=True)
        session = Session(program.encode(), folder / "a.plastron", options, environ={})
        found = list(session.diagnostics)
        assert not found, found
        plan, told = session.plan()
        self.found: list[Diagnostic] = [*found, *told]
        self.text = text
        if plan.files:
            assert write(plan).diagnostics == ()
            self.text = file.read_text()
        lines = ndiff(text.splitlines(), self.text.splitlines())
        self.diff = [line.rstrip() for line in lines if line[0] in "+-"]
