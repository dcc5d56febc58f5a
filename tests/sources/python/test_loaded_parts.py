"""Actions, parameters and timers of loaded nodes: what they are, and what statements change."""

from __future__ import annotations

from pathlib import Path

import pytest
from loaded_nodes import FILES, RCLPY_HEAD, changed, loaded

from plastron_tui.model.kinds import Parameter, Timer
from plastron_tui.ros.parameters import ParameterType
from plastron_tui.session import Session

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
            "driver sends_goal to 'other' of action_type Fibonacci with input none",
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
            "import rospy\nrospy.init_node('a')\n\n\nclass A:\n    def __init__(self):\n"
            "        self.a = 1\n\n    def look(self):\n"
            "        self.a = check(rospy.get_param_cached('~a', self.a))\n\n\nA().look()\n",
            "driver no_longer_has_parameter 'a'\n"
            "driver has_parameter 'a' of parameter_type int with default 7",
            ["-self.a = 1", "+self.a = 7"],
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
        (
            "self.create_timer(0.5, self.call_home)",
            'def call_home(self):\n        """Call home, and drive there."""\n'
            "        if self.far:\n            self.drive()",
            {"call_home": 2.0},
        ),
        (
            "self.create_timer(0.5, self.publish_state)",
            'def publish_state(self):\n        """Publish to the display."""\n'
            "        self.pub.publish(Twist())\n        self.display.show()",
            {"publish_state": 2.0},
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
