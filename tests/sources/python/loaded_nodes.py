"""Small nodes of every shape, and what statements make of them when they are loaded."""

from __future__ import annotations

import difflib
from pathlib import Path

from plastron_tui.model.workspace import Node
from plastron_tui.session import Session

RCLPY_HEAD = (
    "import rclpy\nfrom geometry_msgs.msg import Twist\nfrom rclpy.node import Node\n"
    "from sensor_msgs.msg import LaserScan\nfrom std_srvs.srv import Trigger\n\n\n"
)
ROSPY_HEAD = (
    "import rospy\nfrom geometry_msgs.msg import Twist\nfrom sensor_msgs.msg import LaserScan\n"
    "from std_srvs.srv import Trigger, TriggerResponse\n\n\n"
)
FILES = {
    "rclpy class": RCLPY_HEAD
    + """\
class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.declare_parameter('gain', 1.0)
        self.declare_parameter('idle', 2)
        self.gain = self.get_parameter('gain').value
        self.cmd_pub = self.create_publisher(Twist, 'cmd_vel', 10)
        self.create_subscription(LaserScan, 'scan', self.scan_callback, 10)
        self.create_service(Trigger, 'reset', self.reset_callback)
        self.timer = self.create_timer(0.5, self.tick)

    def scan_callback(self, msg):
        self.last = msg

    def reset_callback(self, request, response):
        self.last = None
        return response

    def tick(self):
        self.cmd_pub.publish(Twist())
        self.get_logger().info('gain %f' % self.gain)


def main():
    rclpy.init()
    rclpy.spin(Driver())


if __name__ == '__main__':
    main()
""",
    "rclpy script": RCLPY_HEAD
    + """\
rclpy.init()
node = rclpy.create_node('driver')
node.declare_parameter('gain', 1.0)
node.declare_parameter('idle', 2)
gain = node.get_parameter('gain').value
cmd_pub = node.create_publisher(Twist, 'cmd_vel', 10)


def scan_callback(msg):
    print(msg)


def reset_callback(request, response):
    print(request)
    return response


def tick():
    cmd_pub.publish(Twist())
    print(gain)


node.create_subscription(LaserScan, 'scan', scan_callback, 10)
node.create_service(Trigger, 'reset', reset_callback)
timer = node.create_timer(0.5, tick)
rclpy.spin(node)
""",
    "rospy class": ROSPY_HEAD
    + """\
class Driver:
    def __init__(self):
        self.gain = rospy.get_param('~gain', 1.0)
        self.idle = rospy.get_param('~idle', 2)
        self.cmd_pub = rospy.Publisher('cmd_vel', Twist, queue_size=10)
        rospy.Subscriber('scan', LaserScan, self.scan_callback)
        rospy.Service('reset', Trigger, self.reset_callback)
        self.timer = rospy.Timer(rospy.Duration(0.5), self.tick)

    def scan_callback(self, msg):
        self.last = msg

    def reset_callback(self, request):
        self.last = None
        return TriggerResponse()

    def tick(self, event):
        self.cmd_pub.publish(Twist())
        rospy.loginfo('gain %f', self.gain)


if __name__ == '__main__':
    rospy.init_node('driver')
    Driver()
    rospy.spin()
""",
    "rospy script": ROSPY_HEAD
    + """\
def scan_callback(msg):
    print(msg)


def reset_callback(request):
    print(request)
    return TriggerResponse()


def tick(event):
    cmd_pub.publish(Twist())
    print(gain)


rospy.init_node('driver')
gain = rospy.get_param('~gain', 1.0)
idle = rospy.get_param('~idle', 2)
cmd_pub = rospy.Publisher('cmd_vel', Twist, queue_size=10)
rospy.Subscriber('scan', LaserScan, scan_callback)
rospy.Service('reset', Trigger, reset_callback)
timer = rospy.Timer(rospy.Duration(0.5), tick)
rospy.spin()
""",
}


def changed(folder: Path, text: str, statement: str) -> tuple[set[str], list[str]]:
    """Make a program's change in a file; return what was told, and the lines that differ."""
    (folder / "driver.py").write_text(text)
    program = f"load driver as driver\n{statement}\ngenerate_node driver\n"
    session = Session(program.encode(), folder / "program.plastron")
    plan, found = session.plan()
    after = plan.files[0].text.decode() if plan.files else text
    lines = difflib.ndiff(text.splitlines(), after.splitlines())
    differing = [line[0] + line[2:].strip() for line in lines if line[0] in "+-"]
    return {str(each.code) for each in (*session.diagnostics, *found)}, differing


def loaded(folder: Path, text: str) -> Node:
    (folder / "driver.py").write_text(text)
    session = Session(b"load driver as driver\n", folder / "program.plastron")
    assert not session.diagnostics
    return session.workspace.nodes["driver"]
