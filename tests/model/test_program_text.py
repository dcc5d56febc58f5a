"""What is read of a file as statements: parameters, timers, actions, quality of service."""

from __future__ import annotations

from pathlib import Path

import pytest
from file_sets import one

from plastron_tui.model.program_text import program_of
from plastron_tui.session import Options, Session
from plastron_tui.targets import find_target

FILES = {
    "rclpy": """\
import rclpy
from geometry_msgs.msg import Point
from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor
from rclpy.action import ActionClient, ActionServer
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from tf2_msgs.action import LookupTransform


class Robot(Node):
    def __init__(self):
        super().__init__("robot")
        {line}
        self.declare_parameter("odd")
""",
    "rospy": """\
import rospy
from actionlib import SimpleActionClient, SimpleActionServer
from geometry_msgs.msg import Point
from move_base_msgs.msg import MoveBaseAction


class Robot:
    def __init__(self):
        {line}
        self.odd = rospy.get_param("~odd")


rospy.init_node("robot")
Robot()
""",
}
RANGE = (
    "ParameterDescriptor(floating_point_range=[FloatingPointRange(from_value=0.0, to_value={0})])"
)
READ = [
    (
        "rclpy",
        'self.declare_parameter("speed", 0.5)',
        "robot has_parameter 'speed' of parameter_type float with default 0.5",
    ),
    (
        "rclpy",
        f'self.declare_parameter("speed", 0.5, {RANGE.format("2.0")})',
        "robot has_parameter 'speed' of parameter_type float with default 0.5 between 0 and 2",
    ),
    (
        "rclpy",
        'self.declare_parameter("a.b", ["x", "\\"y\\\\"])',
        'robot has_parameter \'a.b\' of parameter_type string_list with default ["x", "\\"y\\\\"]',
    ),
    (
        "rclpy",
        'self.declare_parameter("n", 3, ParameterDescriptor(description="how many"))',
        "robot has_parameter 'n' of parameter_type int with default 3 described_as \"how many\"",
    ),
    # The default is not what the descriptor allows, or none is known.
    ("rclpy", f'self.declare_parameter("speed", 0.5, {RANGE.format("0.1")})', None),
    ("rclpy", 'self.declare_parameter("speed", Point().x)', None),
    ("rclpy", "self.create_timer(0.5, self.look)", "robot repeats look at 2 hz"),
    ("rclpy", "self.create_timer(1 / 30, self.look)", "robot repeats look at 30 hz"),
    ("rclpy", "self.create_timer(0.5, lambda: None)", None),
    ("rclpy", "self.create_timer(self.period(), self.look)", None),
    ("rclpy", "self.create_timer(1e-9, self.look)", None),
    (
        "rclpy",
        'self.create_subscription(Point, "a", self.hear, qos_profile_sensor_data)',
        "subscribe robot to 'a' of message_type geometry_msgs/Point with qos sensor_data"
        " calling hear",
    ),
    (
        "rclpy",
        'self.create_subscription(Point, "a", self.hear, 3)',
        "subscribe robot to 'a' of message_type geometry_msgs/Point with qos depth 3 calling hear",
    ),
    (
        "rclpy",
        'self.create_subscription(Point, "a", self.hear, 10)',
        "subscribe robot to 'a' of message_type geometry_msgs/Point calling hear",
    ),
    (
        "rclpy",
        'ActionServer(self, LookupTransform, "look", self.do)',
        "robot provides_action 'look' of action_type tf2_msgs/LookupTransform calling do",
    ),
    (
        "rclpy",
        'ActionClient(self, LookupTransform, "look")',
        "robot sends_goal to 'look' of action_type tf2_msgs/LookupTransform with input none",
    ),
    (
        "rospy",
        'self.speed = rospy.get_param("~speed", 0.5)',
        "robot has_parameter 'speed' of parameter_type float with default 0.5",
    ),
    ("rospy", 'self.speed = rospy.get_param("/speed", 0.5)', None),
    ("rospy", "rospy.Timer(rospy.Duration(0.5), self.look)", "robot repeats look at 2 hz"),
    ("rospy", "rospy.Timer(rospy.Duration(0.5), self.look, oneshot=True)", None),
    (
        "rospy",
        'rospy.Publisher("a", Point, queue_size=1, latch=True)',
        "robot publish a_message to 'a' of message_type geometry_msgs/Point with qos latched",
    ),
    (
        "rospy",
        'rospy.Subscriber("a", Point, self.hear, queue_size=1)',
        "subscribe robot to 'a' of message_type geometry_msgs/Point with qos depth 1 calling hear",
    ),
    (
        "rospy",
        'rospy.Publisher("a", Point, queue_size=3)',
        "robot publish a_message to 'a' of message_type geometry_msgs/Point with qos depth 3",
    ),
    (
        "rospy",
        'SimpleActionServer("look", MoveBaseAction, self.do, auto_start=False)',
        "robot provides_action 'look' of action_type move_base_msgs/MoveBase calling do",
    ),
    (
        "rospy",
        'SimpleActionClient("look", MoveBaseAction)',
        "robot sends_goal to 'look' of action_type move_base_msgs/MoveBase with input none",
    ),
]


@pytest.mark.parametrize(("library", "line", "statement"), READ)
def test_what_a_file_has_is_a_statement(library: str, line: str, statement: str | None) -> None:
    target = find_target(library)
    assert target is not None
    text = FILES[library].replace("{line}", line)
    source = target.read(Path("robot.py"), one(text.encode())).source
    assert source is not None
    program = program_of(source, target.ros_version)
    lines = program.splitlines()
    number = text[: text.index(line)].count("\n") + 1
    if statement is None:
        assert any(each.startswith(f"// line {number}: ") for each in lines), program
        statements = [each for each in lines if not each.startswith(("//", "create_node"))]
        assert statements in ([], ["generate_node robot"])
        return
    assert statement in lines, program
    assert not any(each.startswith(f"// line {number}: ") for each in lines)
    is_sent = statement.split()[1] in ("publish", "sends_goal")
    assert is_sent == any("is not read: fill it in above" in each for each in lines)
    session = Session(program.encode(), None, Options(library), environ={})
    wrong = [each for each in session.diagnostics if each.code != "unknown-type"]
    assert wrong == [], program
