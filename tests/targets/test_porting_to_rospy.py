"""What a file of rclpy writes by hand becomes what rospy has for it: before → after."""

from __future__ import annotations

import pytest
from ported_nodes import MARK, ported

NODE = (
    "import rclpy\nfrom message_filters import Subscriber\n"
    "from rclpy.clock import Clock, ROSClock\n"
    "from rclpy.node import Node\nfrom rclpy.qos import QoSProfile, qos_profile_sensor_data\n"
    "from std_msgs.msg import Header, String\n\n\n"
    "class A(Node):\n    def __init__(self):\n        super().__init__('a')\n{}\n\n"
    "    def hear(self, msg):\n        pass\n\n"
    "    def other(self):\n        qos = 1\n        return qos\n"
)

LINES = [
    (
        "sub = Subscriber(self, String, 's')",
        "from message_filters import Subscriber",
        "sub = Subscriber('s', String)",
    ),
    (
        "sub = Subscriber(self, String, 's', qos_profile=5)",
        "",
        "sub = Subscriber('s', String, queue_size=5)",
    ),
    (
        "self.create_subscription(String, 's', self.hear, QoSProfile(depth=7))",
        "",
        "rospy.Subscriber('s', String, self.hear, queue_size=7)",
    ),
    (
        "header = Header(stamp=ROSClock().now().to_msg())",
        "",
        "header = Header(stamp=rospy.Time.now())",
    ),
    (
        "self.create_timer(1, lambda: self.hear(None))",
        "",
        "rospy.Timer(rospy.Duration(1), lambda event: self.hear(None))",
    ),
    ("start = Clock().now()", "", "start = rospy.Time.now()"),
]


@pytest.mark.parametrize(("before", "kept", "after"), LINES)
def test_a_line_of_a_node(before: str, kept: str, after: str) -> None:
    text, found = ported(NODE.format(f"        {before}"), "rclpy")
    assert f"        rospy.init_node('a')\n        {after}\n" in text
    assert kept in text
    assert "rclpy" not in text
    assert not found


MARKS = [
    ("if self.has_parameter('p'):\n            pass", ".has_parameter"),
    ("x = 1; self.get_parameters(['p'])", ".get_parameters"),
    ("x = len(answer.goals_canceling)", ".goals_canceling"),
]


@pytest.mark.parametrize(("line", "what"), MARKS)
def test_a_method_of_the_node_is_marked(line: str, what: str) -> None:
    text, _ = ported(NODE.format(f"        {line}"), "rclpy")
    assert f"        rospy.init_node('a')\n        {MARK}{what}\n        {line}\n" in text


def test_a_node_keeps_the_name_that_it_is_given() -> None:
    text, _ = ported(
        "from rclpy.node import Node\n\n\nclass A(Node):\n    def __init__(self, name):\n"
        "        super().__init__(node_name=name)\n\n\nA('n')\n",
        "rclpy",
    )
    assert "\n        rospy.init_node(name)\n" in text


def test_a_quality_of_service_has_one_mark() -> None:
    line = "self.create_publisher(String, 's', qos_profile_sensor_data)"
    text, found = ported(NODE.format(f"        {line}"), "rclpy")
    assert f"        {MARK}quality of service\n        rospy.Publisher('s', " in text
    assert len(found) == 1
    assert "rclpy" not in text


LAYOUTS = [
    (
        "p = self.create_publisher(\n    String,\n    's',\n    1\n)",
        "p = rospy.Publisher(\n    's',\n    String,\n    queue_size=1\n)",
    ),
    (
        "p = self.create_publisher(\n    String,\n    's',\n    1,\n)",
        "p = rospy.Publisher(\n    's',\n    String,\n    queue_size=1,\n)",
    ),
    (
        "p = self.create_publisher(String,\n" + " " * 26 + "'s',\n" + " " * 26 + "1)",
        "p = rospy.Publisher('s',\n                    String,\n                    queue_size=1)",
    ),
    (
        "p = self.create_publisher(\n    String, 's',\n    1)",
        "p = rospy.Publisher('s', String, queue_size=1)",
    ),
]


@pytest.mark.parametrize(("before", "after"), LAYOUTS)
def test_an_argument_a_line_stays_so(before: str, after: str) -> None:
    inside = (f"        {each}".replace("\n", "\n        ") for each in (before, after))
    given, wanted = inside
    assert f"\n{wanted}\n" in ported(NODE.format(given), "rclpy")[0]


ANNOTATIONS = [
    ("def f(self, node: Node): pass", "def f(self, node): pass"),
    ("def f(self, node: Node = None): pass", "def f(self, node=None): pass"),
    ("def f(self, node: 'Node' = None): pass", "def f(self, node=None): pass"),
    ("def f(self, node: rclpy.node.Node): pass", "def f(self, node): pass"),
    ("def f(self) -> Node: pass", "def f(self): pass"),
    ("def f(self, node: 'Node | None'): pass", "def f(self, node): pass"),
    ("def f(self, node: Mode): pass", "def f(self, node: Mode): pass"),
    ("node: Node = None", "node = None"),
]


@pytest.mark.parametrize("guard", ["", "if TYPE_CHECKING:\n    "])
@pytest.mark.parametrize(("before", "after"), ANNOTATIONS)
def test_an_annotation_of_the_node_goes(before: str, after: str, guard: str) -> None:
    head = "from typing import TYPE_CHECKING\nimport rclpy\nfrom std_msgs.msg import String\n"
    text, found = ported(
        f"{head}{guard}from rclpy.node import Node\nMode = int\n\n\nclass Helper:\n    {before}\n\n"
        "    def g(self, node):\n        node.create_publisher(String, 's', 1)\n",
        "rclpy",
    )
    assert f"class Helper:\n    {after}\n" in text
    assert "rclpy" not in text
    assert ("TYPE_CHECKING" in text) == (guard == "")
    assert not found


OPTIONS = [
    (
        "qos = QoSProfile(depth=1)\nself.create_publisher(String, 's', qos)",
        "rospy.Publisher('s', String, queue_size=1)",
    ),
    (
        "qos = QoSProfile(depth=1, reliability=ReliabilityPolicy.RELIABLE)\n"
        "self.create_publisher(String, 's', qos)",
        "rospy.Publisher('s', String, queue_size=1)",
    ),
    (
        "qos = QoSProfile(depth=1, history=2)\nself.create_publisher(String, 's', qos)",
        f"{MARK}quality of service\nrospy.Publisher('s', String, queue_size=10)",
    ),
    (
        "qos = QoSProfile(depth=1)\nqos.history = 1\nself.create_publisher(String, 's', qos)",
        f"{MARK}quality of service\nrospy.Publisher('s', String, queue_size=10)",
    ),
    (
        "self.qos = qos_profile_sensor_data\n"
        "self.create_subscription(String, 's', self.hear, self.qos)",
        f"{MARK}quality of service\nrospy.Subscriber('s', String, self.hear)",
    ),
    (
        "qos = QoSProfile(depth=1)\nprint(qos)",
        f"{MARK}rclpy.qos.QoSProfile\nqos = QoSProfile(depth=1)\nprint(qos)",
    ),
]


@pytest.mark.parametrize(("before", "after"), OPTIONS)
def test_a_variable_of_an_option_goes_with_its_last_use(before: str, after: str) -> None:
    inside = (f"        {each}".replace("\n", "\n        ") for each in (before, after))
    given, wanted = inside
    text, _ = ported(NODE.format(given), "rclpy")
    assert f"rospy.init_node('a')\n{wanted}\n" in text
    assert ("rclpy" in text) == ("rclpy" in after)


def test_an_import_goes_with_its_last_use() -> None:
    text, _ = ported(
        "import sys\nimport rclpy\nrclpy.init(args=sys.argv)\nx = rclpy.ok()\n", "rclpy"
    )
    assert text == "import rospy\nx = not rospy.is_shutdown()\n"
