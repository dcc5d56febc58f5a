"""What the reader says of timers and actions, and of what the transitions of a node make."""

from __future__ import annotations

from pathlib import Path

import pytest
from file_sets import one

from plastron_tui.model.endpoint_details import ActionDetails, TimerDetails
from plastron_tui.model.inspection import inspect_json, inspect_text
from plastron_tui.model.source import EndpointKind, SourceUnit
from plastron_tui.sources.python import read_python

ROSPY = """\
#!/usr/bin/env python3
import rospy
from rospy import Duration, Timer

HZ = 20.0
PERIOD = Duration(0.25)


class Clock:
    def __init__(self, seconds, often=4.0):
        self.rate = rospy.get_param('~rate', 50)
        self.wait = 0.2
        self.changed = 1.0
        self.given = seconds
        self.sure = 1.0 / often
        {call}

    def tick(self, event):
        self.changed = 2.0


rospy.init_node('clock')
Clock(float(input()))
"""
RCLPY = """\
from rclpy.node import Node
from rclpy.duration import Duration

PERIOD = 0.5


class Clock(Node):
    def __init__(self):
        super().__init__('clock')
        self.declare_parameter('rate', 20.0)
        self.declare_parameter('hz')
        self.rate = self.get_parameter('rate').value
        held = self.get_parameter('rate')
        {call}

    def tick(self):
        pass
"""


def read(text: str) -> SourceUnit:
    source = read_python(Path("x.py"), one(text.encode())).source
    assert source is not None
    return source


TIMERS = [
    (ROSPY, "rospy.Timer(rospy.Duration(0.1), self.tick)", TimerDetails(0.1)),
    (ROSPY, "Timer(Duration(2), self.tick)", TimerDetails(2.0)),
    (ROSPY, "rospy.Timer(period=rospy.Duration(secs=1, nsecs=500000000), callback=self.tick)",
     TimerDetails(1.5)),
    (ROSPY, "rospy.Timer(rospy.Duration(nsecs=10), self.tick)", TimerDetails(1e-8)),
    (ROSPY, "rospy.Timer(rospy.Duration(), self.tick)", TimerDetails(0.0)),
    (ROSPY, "rospy.Timer(rospy.Duration.from_sec(3.0), self.tick)", TimerDetails(3.0)),
    (ROSPY, "rospy.Timer(rospy.Duration(1 / HZ), self.tick)", TimerDetails(0.05)),
    (ROSPY, "rospy.Timer(PERIOD, self.tick)", TimerDetails(0.25)),
    (ROSPY, "rospy.Timer(rospy.Duration(self.wait), self.tick)", TimerDetails(0.2)),
    (ROSPY, "rospy.Timer(rospy.Duration(self.sure), self.tick)", TimerDetails(0.25)),
    (ROSPY, "rospy.Timer(rospy.Rate(10).sleep_dur, self.tick)", TimerDetails(0.1)),
    (ROSPY, "rospy.Timer(rospy.Rate(0).sleep_dur, self.tick)", TimerDetails()),
    (ROSPY, "rospy.Timer(rospy.Duration(1), self.tick, True)", TimerDetails(1.0, True)),
    (ROSPY, "rospy.Timer(rospy.Duration(1), self.tick, oneshot=True)", TimerDetails(1.0, True)),
    (ROSPY, "rospy.Timer(rospy.Duration(1), self.tick, oneshot=False)", TimerDetails(1.0)),
    (ROSPY, "rospy.Timer(rospy.Duration(1.0 / self.rate), self.tick)",
     TimerDetails(0.02, is_guess=True)),
    (ROSPY, "rospy.Timer(rospy.Duration(self.changed), self.tick)", TimerDetails()),
    (ROSPY, "rospy.Timer(rospy.Duration(self.given), self.tick)", TimerDetails()),
    (ROSPY, "rospy.Timer(rospy.Duration(*self.given), self.tick)", TimerDetails()),
    (ROSPY, "rospy.Timer(rospy.Duration(-1), self.tick)", TimerDetails()),
    (ROSPY, "rospy.Timer(rospy.Duration(rospy.get_param('~period')), self.tick)", TimerDetails()),
    (RCLPY, "self.create_timer(0.1, self.tick)", TimerDetails(0.1)),
    (RCLPY, "self.create_timer(1 / 10, self.tick)", TimerDetails(0.1)),
    (RCLPY, "self.create_timer(1, self.tick)", TimerDetails(1.0)),
    (RCLPY, "self.create_timer(timer_period_sec=PERIOD, callback=self.tick)", TimerDetails(0.5)),
    (RCLPY, "self.create_timer(PERIOD * 2, self.tick)", TimerDetails(1.0)),
    (RCLPY, "self.create_timer(Duration(seconds=1.5).nanoseconds, self.tick)", TimerDetails()),
    (RCLPY, "self.create_timer(1.0 / self.rate, self.tick)", TimerDetails(0.05, is_guess=True)),
    (RCLPY, "self.create_timer(1.0 / held.value, self.tick)", TimerDetails(0.05, is_guess=True)),
    (RCLPY, "self.create_timer(1 / self.get_parameter('rate').get_parameter_value().double_value,"
     " self.tick)", TimerDetails(0.05, is_guess=True)),
    (RCLPY, "self.create_timer(1 / self.get_parameter('hz').value, self.tick)", TimerDetails()),
    (RCLPY, "self.create_timer(self.declare_parameter('p', 3).value, self.tick)",
     TimerDetails(3.0, is_guess=True)),
    (RCLPY, "self.create_timer(True, self.tick)", TimerDetails()),
    (RCLPY, "self.create_timer(float('inf'), self.tick)", TimerDetails()),
    (RCLPY, "self.create_timer(period, self.tick)", TimerDetails()),
]  # fmt: skip


@pytest.mark.parametrize(("text", "call", "expected"), TIMERS)
def test_a_timer_has_the_period_that_the_file_says(text, call, expected):
    (timer,) = read(text.replace("{call}", call)).of_kind(EndpointKind.TIMER)
    assert timer.details == pytest.approx(expected)
    assert timer.callback == "tick"


DESTROY = "self.destroy_timer(timer)"
ANEW = "self.destroy_timer(self.timer)\n        self.timer = self.create_timer(1.0, self.tick)"
WAITS = [
    ("timer = self.create_timer(1.0, self.tick)\n        self.spin()\n        " + DESTROY, 0),
    ("self.timer = self.create_timer(1.0, self.tick)\n        self.destroy_timer(self.timer)", 0),
    ("timer = self.create_timer(1.0, self.tick)\n        try:\n            self.spin()\n"
     "        finally:\n            " + DESTROY, 0),
    ("timer = self.create_timer(1.0, self.tick)", 1),
    (ANEW, 1),
    ("timer = self.create_timer(1.0, self.tick)\n        if self.broken:\n            " + DESTROY,
     1),
    ("timer = self.create_timer(1.0, self.tick)\n        self.destroy_timer(self.other)", 1),
    ("timer = self.create_timer(1.0, self.tick)\n        self.cancel(timer)", 1),
]  # fmt: skip


@pytest.mark.parametrize(("lines", "count"), WAITS)
def test_a_timer_that_its_function_destroys_is_a_wait(lines: str, count: int) -> None:
    found = read(RCLPY.replace("{call}", lines)).of_kind(EndpointKind.TIMER)
    assert len(list(found)) == count


ACTIONS_1 = """\
import actionlib
import rospy
from dock_msgs.msg import DockAction


class Dock:
    def __init__(self):
        {call}

    def run(self, goal):
        pass


rospy.init_node('dock')
Dock()
"""
ACTIONS_2 = """\
from functools import partial
from dock_msgs.action import Dock
from rclpy.action import ActionClient, ActionServer
from rclpy.node import Node


class Docking(Node):
    def __init__(self):
        super().__init__('dock')
        {call}

    def go(self):
        self.a.send_goal_async(Dock.Goal(), self.on_feedback)
        self.b.send_goal_async(Dock.Goal(), feedback_callback=self.one)
        self.b.send_goal_async(Dock.Goal(), feedback_callback=self.other)
"""
SERVER_1 = "self.a = actionlib.SimpleActionServer('dock', DockAction, {}auto_start=False)"
CLIENT_1 = "self.a = actionlib.SimpleActionClient('dock', DockAction)"
CLIENT_2 = "self.{} = ActionClient(self, Dock, 'dock')"
ACTIONS = [
    (ACTIONS_1, SERVER_1.format("self.run, "), "run", ActionDetails()),
    (ACTIONS_1, SERVER_1.format("") + "; self.a.register_goal_callback(self.on_goal)"
     "; self.a.register_preempt_callback(self.stop)", None,
     ActionDetails(goal="on_goal", cancel="stop")),
    (ACTIONS_1, "actionlib.ActionServer('dock', DockAction, self.on_goal, self.stop, False)",
     "on_goal", ActionDetails(cancel="stop")),
    (ACTIONS_1, CLIENT_1, None, ActionDetails()),
    (ACTIONS_1, f"{CLIENT_1}; self.a.send_goal(1, self.done, self.active, self.heard)", None,
     ActionDetails(accepted="active", feedback="heard", result="done")),
    (ACTIONS_1, f"{CLIENT_1}; self.a.send_goal(1, feedback_cb=self.heard)", None,
     ActionDetails(feedback="heard")),
    (ACTIONS_1, f"{CLIENT_1}; other.send_goal(1, feedback_cb=self.heard)", None, ActionDetails()),
    (ACTIONS_1, f"{CLIENT_1}; self.a.send_goal(1, feedback_cb=lambda f: f)", None,
     ActionDetails()),
    (ACTIONS_2, "ActionServer(self, Dock, 'dock', self.run)", "run", ActionDetails()),
    (ACTIONS_2, "ActionServer(self, Dock, 'dock', execute_callback=self.run, goal_callback=ask,"
     " handle_accepted_callback=self.begin, cancel_callback=partial(self.stop, 1))", "run",
     ActionDetails("ask", "begin", "stop")),
    (ACTIONS_2, "self.s = ActionServer(self, Dock, 'dock', self.run)"
     "; self.s.register_cancel_callback(self.stop)", "run", ActionDetails(cancel="stop")),
    (ACTIONS_2, CLIENT_2.format("a"), None, ActionDetails(feedback="on_feedback")),
    (ACTIONS_2, CLIENT_2.format("b"), None, ActionDetails()),
]  # fmt: skip


@pytest.mark.parametrize(("text", "call", "callback", "expected"), ACTIONS)
def test_an_action_has_its_callbacks(text, call, callback, expected):
    kinds = EndpointKind.ACTION_SERVER, EndpointKind.ACTION_CLIENT
    (action,) = [
        each for each in read(text.replace("{call}", call)).endpoints if each.kind in kinds
    ]
    assert (action.callback, action.details) == (callback, expected)


MADE = "self.create_publisher(String, 'x', 1)"
LIFECYCLE = f"""\
import rclpy
from rclpy.lifecycle import LifecycleNode
from rclpy.lifecycle import Node as Managed
from rclpy.node import Node
from std_msgs.msg import String


def advertise(node):
    node.create_publisher(String, 'x', 1)


class Part:
    def attach(self):
        {MADE}


class Cell(BASE):
    def __init__(self):
        super().__init__('cell')
        BEGIN

    def on_configure(self, state):
        CONFIGURE
        return super().on_configure(state)

    def on_activate(self, state):
        ACTIVATE
        return super().on_activate(state)

    def make(self):
        MAKE

    def make_all(self):
        ALL

    def on_message(self, message):
        HEARD
"""


def lifecycle(base: str = "LifecycleNode", **lines: str) -> str:
    text = LIFECYCLE.replace("BASE", base)
    for place in ("BEGIN", "CONFIGURE", "ACTIVATE", "MAKE", "ALL", "HEARD"):
        text = text.replace(place, lines.get(place.lower(), "pass"))
    return text


TRANSITIONS = [
    ({"begin": MADE}, None),
    ({"configure": MADE}, "on_configure"),
    ({"configure": MADE.replace("create_", "create_lifecycle_")}, "on_configure"),
    ({"activate": MADE}, "on_activate"),
    ({"activate": MADE, "base": "Managed"}, "on_activate"),
    ({"activate": MADE, "base": "rclpy.lifecycle.LifecycleNode"}, "on_activate"),
    ({"configure": f"for each in 'ab':\n            {MADE}"}, "on_configure"),
    ({"configure": f"self.all = [{MADE} for each in 'ab']"}, "on_configure"),
    ({"configure": f"self.later = lambda: {MADE}"}, None),
    ({"configure": "self.make()", "make": MADE}, "on_configure"),
    ({"activate": "self.make_all()", "all": "self.make()", "make": MADE}, "on_activate"),
    ({"configure": "self.make()", "activate": "self.make()", "make": MADE}, None),
    ({"begin": "self.make()", "activate": "self.make()", "make": MADE}, None),
    ({"make": MADE}, None),
    ({"configure": "self.make()", "all": "self.make()", "make": MADE}, None),
    ({"configure": "self.make()", "make": f"{MADE}; self.make()"}, "on_configure"),
    ({"configure": "self.create_timer(1.0, self.make)", "make": MADE}, None),
    ({"configure": "self.make(); later(self.make)", "make": MADE}, None),
    ({"configure": "self.make()  # make it", "make": MADE}, "on_configure"),
    ({"heard": MADE}, None),
    ({"configure": "advertise(self)"}, "on_configure"),
    ({"configure": "Part().attach()", "base": "LifecycleNode, Part"}, "on_configure"),
    ({"configure": "self.attach()", "base": "LifecycleNode, Part"}, "on_configure"),
    ({"configure": MADE, "base": "Node"}, None),
]


@pytest.mark.parametrize(("lines", "transition"), TRANSITIONS)
def test_an_endpoint_is_made_in_the_one_transition_that_leads_to_it(lines, transition):
    found = read(lifecycle(**lines)).of_kind(EndpointKind.PUBLISHER)
    # The function and the mixin are in every file; what nothing calls is in no transition.
    assert {each.transition for each in found} - {None} == {transition} - {None}


@pytest.mark.parametrize(
    ("text", "managed"),
    [
        (lifecycle(), {"cell": True}),
        (lifecycle("Node"), {"cell": False}),
        (f"{lifecycle()}\n\nclass Other(Cell):\n    pass\n", {"cell": True, "Other": True}),
        ("import rclpy.lifecycle\nn = rclpy.lifecycle.LifecycleNode('a')\n", {"a": True}),
        ("import rclpy\nn = rclpy.create_node('a')\n", {"a": False}),
        ("import rospy\nrospy.init_node('a')\n", {"a": False}),
    ],
)
def test_a_node_is_managed_whose_class_is_a_lifecycle_node(text, managed):
    assert {node.label: node.is_managed for node in read(text).nodes} == managed


def test_what_a_base_class_of_the_package_makes_has_its_details(tmp_path: Path):
    base = lifecycle(configure="self.create_timer(PERIOD, print)").replace("Cell", "Base")
    (tmp_path / "base.py").write_text(f"{base}\n\nPERIOD = 0.5\n")
    text = "from base import Base\n\n\nclass Arm(Base):\n    pass\n\n\nimport rclpy\n"
    source = read_python(tmp_path / "arm.py", one(text.encode())).source
    assert source is not None
    (timer,) = source.of_kind(EndpointKind.TIMER)
    assert source.nodes[0].is_managed
    assert (timer.file, timer.details, timer.transition) == (
        "base.py", TimerDetails(0.5), "on_configure",
    )  # fmt: skip


SHOWN = """\
from dock_msgs.action import Dock
from rcl_interfaces.msg import IntegerRange, ParameterDescriptor
from rclpy.action import ActionServer
from rclpy.lifecycle import LifecycleNode


class Cell(LifecycleNode):
    def __init__(self):
        super().__init__('cell')
        self.declare_parameter('rate', 10, ParameterDescriptor(
            description='how often', read_only=True,
            integer_range=[IntegerRange(from_value=1, to_value=50, step=1)]))
        self.declare_parameter('joints', ['a'])
        self.declare_parameter('path', find())
        self.get_parameter('rate')

    def on_activate(self, state):
        self.create_timer(1 / self.get_parameter('rate').value, self.tick)
        ActionServer(self, Dock, 'dock', self.run, cancel_callback=self.stop)
        return super().on_activate(state)
"""


def test_inspect_tells_people_all_of_it():
    assert inspect_text(read(SHOWN)).splitlines()[1:] == [
        "  node cell (managed)",
        "    line 19  action server  dock                                    "
        "dock_msgs/Dock calling run cancel stop made in on_activate",
        "    line 18  timer          (1 / self.get_parameter('rate').value)  "
        "calling tick every 0.1 s (a guess) made in on_activate",
        "    line 10  parameter      rate                                    "
        "int = 10 from 1 to 50 by 1 (read only) (how often)",
        '    line 13  parameter      joints                                  string_list = ["a"]',
        "    line 14  parameter      path                                    = find()",
        "    line 15  parameter      rate",
        "    line 18  parameter      rate                                    made in on_activate",
    ]


def test_inspect_has_all_of_it_as_data():
    (node,) = inspect_json(read(SHOWN))["nodes"]
    assert node["managed"] is True
    assert node["timers"] == [
        {
            "expression": "1 / self.get_parameter('rate').value",
            "callback": "tick",
            "period": 0.1,
            "period_guess": True,
            "transition": "on_activate",
            "line": 18,
        }
    ]
    assert node["action_servers"][0]["cancel_callback"] == "stop"
    rate, joints, path, *_ = node["parameters"]
    assert rate == {
        "name": "rate",
        "expression": "'rate'",
        "parameter_type": "int",
        "default_expression": "10",
        "default_value": 10,
        "range": {"from": 1, "to": 50, "step": 1},
        "description": "how often",
        "read_only": True,
        "line": 10,
    }
    assert joints["default_value"] == ["a"]
    assert path["default_expression"] == "find()"
    assert "default_value" not in path
