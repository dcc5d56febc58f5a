"""Each statement about what a node does more, on small nodes of every shape.

A statement changes the file, or a diagnostic says why it does not: nothing is ignored, and nothing
that a user wrote raises.
"""

from __future__ import annotations

import difflib
from pathlib import Path

import pytest

from plastron_tui.model.kinds import Parameter, Timer
from plastron_tui.model.workspace import Node
from plastron_tui.ros.parameters import ParameterType
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
GO = "create_message go of message_type Twist and input none\n"
AGAIN = "driver no_longer_has_parameter 'gain'\ndriver has_parameter 'gain' of parameter_type "
SCAN = "'scan' of message_type sensor_msgs/LaserScan"
ADD = "driver provides_service 'add' of service_type AddTwoInts "

# What each of the four files gets: a part of the lines that differ, or the code of the refusal.
ROWS: dict[str, tuple[str, str, str, str]] = {
    "driver has_parameter 'speed' of parameter_type float with default 0.5": (
        "+self.declare_parameter('speed', 0.5)",
        "+node.declare_parameter('speed', 0.5)",
        "+self.speed = rospy.get_param('~speed', 0.5)",
        "+speed = rospy.get_param('~speed', 0.5)",
    ),
    'driver has_parameter \'names\' of parameter_type string_list with default ["a", "b"]': (
        "+self.declare_parameter('names', ['a', 'b'])",
        "+node.declare_parameter('names', ['a', 'b'])",
        "+self.names = rospy.get_param('~names', ['a', 'b'])",
        "+names = rospy.get_param('~names', ['a', 'b'])",
    ),
    "driver has_parameter 'speed' of parameter_type int with default 1 between 0 and 2": (
        "+'speed', 1, ParameterDescriptor(integer_range=[IntegerRange(from_value=0, to_value=2)])",
        "+'speed', 1, ParameterDescriptor(integer_range=[IntegerRange(from_value=0, to_value=2)])",
        "not-in-ros-1",
        "not-in-ros-1",
    ),
    "driver no_longer_has_parameter 'gain'": ("endpoint-in-use",) * 4,
    "driver no_longer_has_parameter 'idle'": (
        "-self.declare_parameter('idle', 2)",
        "-node.declare_parameter('idle', 2)",
        "-self.idle = rospy.get_param('~idle', 2)",
        "-idle = rospy.get_param('~idle', 2)",
    ),
    f"{AGAIN}float with default 2.5": (
        "+self.declare_parameter('gain', 2.5)",
        "+node.declare_parameter('gain', 2.5)",
        "+self.gain = rospy.get_param('~gain', 2.5)",
        "+gain = rospy.get_param('~gain', 2.5)",
    ),
    f"{AGAIN}float with default 1 between 0 and 3": (
        "+floating_point_range=[FloatingPointRange(from_value=0.0, to_value=3.0)]",
        "+floating_point_range=[FloatingPointRange(from_value=0.0, to_value=3.0)]",
        "not-in-ros-1",
        "not-in-ros-1",
    ),
    f'{AGAIN}string with default "x"': ("other-type",) * 4,
    "driver repeats blink at 2 hz": (
        "+self.blink_timer = self.create_timer(0.5, self.blink)",
        "+node.create_timer(0.5, blink)",
        "+self.blink_timer = rospy.Timer(rospy.Duration(0.5), self.blink)",
        "+rospy.Timer(rospy.Duration(0.5), blink)",
    ),
    "driver repeats scan_callback at 2 hz": ("function-conflict",) * 4,
    "driver repeats blink at parameter 'gain' hz": ("edit-refused",) * 4,
    "driver stop_repeating tick": (
        "-self.timer = self.create_timer(0.5, self.tick)",
        "-timer = node.create_timer(0.5, tick)",
        "-self.timer = rospy.Timer(rospy.Duration(0.5), self.tick)",
        "-timer = rospy.Timer(rospy.Duration(0.5), tick)",
    ),
    "driver stop_repeating tick\ndriver repeats tick at 5 hz": (
        "+self.timer = self.create_timer(0.2, self.tick)",
        "+timer = node.create_timer(0.2, tick)",
        "+self.timer = rospy.Timer(rospy.Duration(0.2), self.tick)",
        "+timer = rospy.Timer(rospy.Duration(0.2), tick)",
    ),
    f"unsubscribe driver from 'scan'\nsubscribe driver to {SCAN} with qos depth 5": (
        "+self.create_subscription(LaserScan, 'scan', self.scan_callback, 5)",
        "+node.create_subscription(LaserScan, 'scan', scan_callback, 5)",
        "+rospy.Subscriber('scan', LaserScan, self.scan_callback, queue_size=5)",
        "+rospy.Subscriber('scan', LaserScan, scan_callback, queue_size=5)",
    ),
    "subscribe driver to 'joy' of message_type sensor_msgs/Joy with qos sensor_data": (
        "+self.create_subscription(Joy, 'joy', self.joy_callback, qos_profile_sensor_data)",
        "+node.create_subscription(Joy, 'joy', joy_callback, qos_profile_sensor_data)",
        "not-in-ros-1",
        "not-in-ros-1",
    ),
    f"{GO}driver publish go to 'out' of message_type Twist with qos best_effort, depth 3": (
        "+Twist, 'out', QoSProfile(depth=3, reliability=ReliabilityPolicy.BEST_EFFORT)",
        "+Twist, 'out', QoSProfile(depth=3, reliability=ReliabilityPolicy.BEST_EFFORT)",
        "not-in-ros-1",
        "not-in-ros-1",
    ),
    f"{GO}driver publish go to 'out' of message_type Twist once": (
        "+self.out_is_heard = self.out_pub.get_subscription_count() > 0",
        "edit-refused",
        "+self.out_pub = rospy.Publisher('out', Twist, queue_size=1, latch=True)",
        "+out_pub = rospy.Publisher('out', Twist, queue_size=1, latch=True)",
    ),
    f"{GO}driver publish go to 'cmd_vel' of message_type Twist once": ("edit-refused",) * 4,
    f"{GO}driver publish go to 'cmd_vel' of message_type Twist with qos depth 10": (
        "+self.cmd_pub.publish(Twist())",
        "+cmd_pub.publish(Twist())",
        "+self.cmd_pub.publish(Twist())",
        "+cmd_pub.publish(Twist())",
    ),
    f"{GO}driver publish go to 'cmd_vel' of message_type Twist with qos depth 5": (
        ("edit-refused",) * 4
    ),
    f"{GO}driver publish go to 'cmd_vel' of message_type Twist with qos best_effort": (
        "edit-refused",
        "edit-refused",
        "not-in-ros-1",
        "not-in-ros-1",
    ),
    f"{GO}driver publish go to 'out' of message_type Twist for_each 'scan'": ("edit-refused",) * 4,
    f"{GO}driver publish go to 'out' of message_type Twist at parameter 'gain' hz": (
        ("edit-refused",) * 4
    ),
    "create_message go of message_type Twist and input linear.x=parameter 'gain' * 2\n"
    "driver publish go to 'out' of message_type Twist": (
        "+self.out_pub.publish(Twist(linear=Vector3(x=self.get_parameter('gain').value * 2)))",
        "+out_pub.publish(Twist(linear=Vector3(x=node.get_parameter('gain').value * 2)))",
        "+Twist(linear=Vector3(x=rospy.get_param('~gain', 1.0) * 2))",
        "+out_pub.publish(Twist(linear=Vector3(x=rospy.get_param('~gain', 1.0) * 2)))",
    ),
    f"{ADD}answering sum=received.a + 1": (
        "+return AddTwoInts.Response(sum=request.a + 1)",
        "+return AddTwoInts.Response(sum=request.a + 1)",
        "+return AddTwoIntsResponse(sum=request.a + 1)",
        "+return AddTwoIntsResponse(sum=request.a + 1)",
    ),
    "driver stop_service 'reset'\n"
    "driver provides_service 'reset' of service_type Trigger answering success=True": (
        ("edit-refused",) * 4
    ),
    "driver client_requests 'calm' of service_type Trigger with input none at 2 hz": (
        ("edit-refused",) * 4
    ),
    "driver stop_action 'fib'": ("not-serving",) * 4,
    "driver stop_goal to 'fib'": ("not-sending",) * 4,
}  # fmt: skip
CASES = [
    pytest.param(file, statement, expected, id=f"{statement.splitlines()[-1]} | {file}")
    for statement, row in ROWS.items()
    for file, expected in zip(FILES, row, strict=True)
]


@pytest.mark.parametrize(("file", "statement", "expected"), CASES)
def test_a_statement_changes_a_file_or_says_why_not(
    tmp_path: Path, file: str, statement: str, expected: str
) -> None:
    codes, lines = changed(tmp_path, FILES[file], statement)
    if expected[0] not in "+-":
        assert expected in codes
        return
    assert not codes - {"uncalled-function"}
    assert any(line.startswith(expected) for line in lines), lines


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


ACTIONS_RCLPY = """\
import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient, ActionServer
from rclpy.node import Node


class Server(Node):
    def __init__(self):
        super().__init__('server')
        self._server = ActionServer(self, Fibonacci, 'fib', self.execute)
        self._client = ActionClient(self, Fibonacci, 'other')

    def execute(self, goal_handle):
        goal_handle.succeed()
        return Fibonacci.Result()


def main():
    rclpy.init()
    rclpy.spin(Server())
"""
ACTIONS_ROSPY = """\
import actionlib
import rospy
from actionlib_tutorials.msg import FibonacciAction

rospy.init_node('server')
server = actionlib.SimpleActionServer('fib', FibonacciAction, auto_start=False)
server.start()
client = actionlib.SimpleActionClient('other', FibonacciAction)
client.wait_for_server()
rospy.spin()
"""


@pytest.mark.parametrize(
    ("text", "statement", "expected"),
    [
        (
            ACTIONS_RCLPY,
            "driver stop_action 'fib'",
            [
                "-from rclpy.action import ActionClient, ActionServer",
                "+from rclpy.action import ActionClient",
                "-self._server = ActionServer(self, Fibonacci, 'fib', self.execute)",
            ],
        ),
        (
            ACTIONS_RCLPY,
            "driver stop_goal to 'other'",
            [
                "-from rclpy.action import ActionClient, ActionServer",
                "+from rclpy.action import ActionServer",
                "-self._client = ActionClient(self, Fibonacci, 'other')",
            ],
        ),
        (
            ACTIONS_ROSPY,
            "driver stop_action 'fib'",
            [
                "-server = actionlib.SimpleActionServer('fib', FibonacciAction, auto_start=False)",
                "-server.start()",
            ],
        ),
        (
            ACTIONS_ROSPY,
            "driver stop_goal to 'other'",
            [
                "-client = actionlib.SimpleActionClient('other', FibonacciAction)",
                "-client.wait_for_server()",
            ],
        ),
        (
            ACTIONS_RCLPY,
            "driver provides_action 'more' of action_type example_interfaces/Fibonacci",
            "edit-refused",
        ),
        (
            ACTIONS_RCLPY.replace("    def execute", "    def go(self):\n"
                                  "        self._client.send_goal_async(Fibonacci.Goal())\n\n"
                                  "    def execute"),
            "driver stop_goal to 'other'",
            "endpoint-in-use",
        ),
        (
            ACTIONS_RCLPY,
            "driver stop_action 'fib'\n"
            "driver provides_action 'fib' of action_type example_interfaces/Fibonacci",
            [],
        ),
    ],
)  # fmt: skip
def test_actions(tmp_path: Path, text: str, statement: str, expected: list[str] | str) -> None:
    codes, lines = changed(tmp_path, text, statement)
    if isinstance(expected, str):
        assert expected in codes
    else:
        assert not codes - {"uncalled-function"}
        assert lines == expected


def parameters(calls: str) -> str:
    head, tail = RCLPY_HEAD + "class A(Node):\n    def __init__(self):\n", "\n\nrclpy.init()\nA()\n"
    inner = "".join(f"        {line}\n" for line in ["super().__init__('a')", *calls.splitlines()])
    return head + inner + tail


LISTED = "self.declare_parameters('', [('a', 1), ('b', 2.0)])"
RANGED = (
    "self.declare_parameter('a', 1, ParameterDescriptor(integer_range=["
    "IntegerRange(from_value=0, to_value=5)]))"
)
DESCRIBED = "from rcl_interfaces.msg import IntegerRange, ParameterDescriptor\n"


@pytest.mark.parametrize(
    ("text", "statement", "expected"),
    [
        (
            parameters(LISTED),
            "driver no_longer_has_parameter 'a'",
            [f"-{LISTED}", "+self.declare_parameters('', [('b', 2.0)])"],
        ),
        (
            parameters(LISTED.replace(", ('b', 2.0)", "")),
            "driver no_longer_has_parameter 'a'",
            ["-self.declare_parameters('', [('a', 1)])"],
        ),
        (
            parameters(LISTED),
            "driver no_longer_has_parameter 'b'\n"
            "driver has_parameter 'b' of parameter_type float with default 3",
            [f"-{LISTED}", "+self.declare_parameters('', [('a', 1), ('b', 3.0)])"],
        ),
        (
            parameters("self.declare_parameter('a', 1)\nself.a = self.get_parameter('a').value"),
            "driver no_longer_has_parameter 'a'",
            ["-self.declare_parameter('a', 1)", "-self.a = self.get_parameter('a').value"],
        ),
        (
            parameters("self.declare_parameter('a', 1)\nprint(self.get_parameter('a').value)"),
            "driver no_longer_has_parameter 'a'",
            "endpoint-in-use",
        ),
        (
            DESCRIBED + parameters(RANGED),
            "driver no_longer_has_parameter 'a'\n"
            "driver has_parameter 'a' of parameter_type int with default 7 between 2 and 9",
            [
                f"-{RANGED}",
                "+self.declare_parameter('a', 7, ParameterDescriptor("
                "integer_range=[IntegerRange(from_value=2, to_value=9)]))",
            ],
        ),
        (
            DESCRIBED + parameters(RANGED),
            "driver no_longer_has_parameter 'a'\n"
            "driver has_parameter 'a' of parameter_type int with default 7",
            "edit-refused",
        ),
        (
            "import rospy\nrospy.init_node('a')\nrospy.set_param('~a', rospy.get_param('~a', 1))\n",
            "driver no_longer_has_parameter 'a'",
            ["-rospy.set_param('~a', rospy.get_param('~a', 1))"],
        ),
        (
            "import rospy\n\n\ndef main():\n    rospy.init_node('a')\n\n\nmain()\n",
            "driver has_parameter 'a' of parameter_type int with default 1",
            ["+rospy.set_param('~a', rospy.get_param('~a', 1))"],
        ),
    ],
)
def test_parameters(tmp_path: Path, text: str, statement: str, expected: list[str] | str) -> None:
    codes, lines = changed(tmp_path, text, statement)
    if isinstance(expected, str):
        assert expected in codes
    else:
        assert not codes - {"not-in-ros-1"}
        assert lines == expected


def test_a_stub_goes_with_its_timer(tmp_path: Path) -> None:
    text = FILES["rclpy script"]
    (tmp_path / "driver.py").write_text(text)
    program = "load driver as driver\ndriver repeats blink at 2 hz\ngenerate_node driver\n"
    plan, _ = Session(program.encode(), tmp_path / "program.plastron").plan()
    with_timer = plan.files[0].text.decode()
    codes, lines = changed(tmp_path, with_timer, "driver stop_repeating blink")
    assert not codes
    assert "-def blink():" in lines


@pytest.mark.parametrize(
    ("timer", "function", "expected"),
    [
        ("self.create_timer(0.5, self.tick)", "def tick(self):\n        pass", {"tick": 2.0}),
        ("self.create_timer(PERIOD, self.tick)", "def tick(self):\n        pass", {"tick": None}),
        ("self.create_timer(0.5, lambda: None)", "def tick(self):\n        pass", {}),
        (
            "self.create_timer(0.5, self.publish_out)",
            'def publish_out(self):\n        """Publish to out; called at its rate."""',
            {},
        ),
        (
            "self.create_timer(0.5, self.publish_out)",
            "def publish_out(self):\n        message = Twist()\n        self.pub.publish(message)",
            {},
        ),
        (
            "self.create_timer(0.5, self.publish_out)",
            "def publish_out(self):\n        self.count += 1\n        self.pub.publish(Twist())",
            {"publish_out": 2.0},
        ),
    ],
)
def test_timers_are_what_a_node_repeats(
    tmp_path: Path, timer: str, function: str, expected: dict[str, float | None]
) -> None:
    text = parameters(timer).replace("\n\n\nrclpy", f"\n\n    {function}\n\n\nrclpy")
    node = loaded(tmp_path, "from else_where import PERIOD\n" + text)
    rates = {name: each.rate and each.rate.hertz for name, each in node.of(Timer).items()}
    assert rates == expected


def loaded(folder: Path, text: str) -> Node:
    (folder / "driver.py").write_text(text)
    session = Session(b"load driver as driver\n", folder / "program.plastron")
    assert not session.diagnostics
    return session.workspace.nodes["driver"]


def test_a_parameter_is_what_all_its_calls_say(tmp_path: Path) -> None:
    calls = f"{RANGED}\nself.a = self.get_parameter('a').get_parameter_value().integer_value"
    node = loaded(tmp_path, DESCRIBED + parameters(calls + "\nself.declare_parameter('s')"))
    assert dict(node.of(Parameter)) == {
        "a": Parameter("a", None, ParameterType.INT, 1, 0, 5),
        "s": Parameter("s"),
    }


def test_a_private_parameter_of_ros_1_has_its_sign(tmp_path: Path) -> None:
    node = loaded(tmp_path, "import rospy\nrospy.init_node('a')\nx = rospy.get_param('~a', 'b')\n")
    assert dict(node.of(Parameter)) == {"~/a": Parameter("~/a", None, ParameterType.STRING, "b")}
