"""The quality of service that hand-written nodes give their topics."""

from __future__ import annotations

from pathlib import Path
from textwrap import indent

import pytest
from file_sets import one

from plastron_tui.model.inspection import inspect_json, inspect_text
from plastron_tui.ros.qos import DEFAULT, PROFILES, Qos
from plastron_tui.ros.qos_words import text_of
from plastron_tui.sources.python.reader import read_python

HEAD = """\
import copy
import rclpy
from rclpy.duration import Duration, Infinite
from rclpy.node import Node
from rclpy.qos import (
    DurabilityPolicy, HistoryPolicy, LivelinessPolicy, QoSDurabilityPolicy, QoSHistoryPolicy,
    QoSPresetProfiles, QoSProfile, QoSReliabilityPolicy, ReliabilityPolicy, qos_profile_parameters,
    qos_profile_sensor_data, qos_profile_system_default,
)
from std_msgs.msg import String

"""


def node(init: str, module: str = "", rest: str = "", given: str = "") -> str:
    """Return a node: what its constructor does, and its methods behind that."""
    body, *methods = init.split("\n\ndef ")
    return (
        f"{HEAD}{module}\n\nclass Talker(Node):\n{indent(rest, '    ')}"
        f"    def __init__(self{given}):\n        super().__init__('talker')\n"
        f"{indent(body, '        ')}\n"
        + "".join(indent(f"\ndef {method}\n", "    ") for method in methods)
    )


def publisher(qos: str) -> str:
    return node(f"self.pub = self.create_publisher(String, 'a', {qos})")


USE = "self.create_publisher(String, 'a', qos)"
USE_OF_SELF = "self.create_publisher(String, 'a', self.qos)"
PUBLISH = "self.create_publisher(String, 'a', {})"
OTHER = "self.start()\n\ndef start(self):\n    " + USE_OF_SELF
SET = OTHER.replace("(self):\n", "(self):\n    self.qos.depth = 3\n")
BEST = "ReliabilityPolicy.BEST_EFFORT"
MAKE = "def make():\n    qos = QoSProfile(depth=6)\n{}    return qos"
KEPT = "durability = DurabilityPolicy.TRANSIENT_LOCAL"
MADE = "\n\nrclpy.init()\nrclpy.spin(Talker({}))\n"

FORMS = {
    publisher("10"): "depth 10",
    publisher("qos_profile=1"): "depth 1",
    publisher("(7)"): "depth 7",
    publisher("qos_profile_sensor_data"): "sensor_data",
    publisher("qos_profile_system_default"): "system_default",
    publisher("rclpy.qos.qos_profile_sensor_data"): "sensor_data",
    publisher("qos_profile_parameters"): "depth 1000",
    publisher("QoSPresetProfiles.SENSOR_DATA.value"): "sensor_data",
    publisher("QoSPresetProfiles.get_from_short_key('sensor_data')"): "sensor_data",
    publisher("QoSProfile(depth=3)"): "depth 3",
    publisher("QoSProfile(depth=True)"): "",
    publisher("QoSProfile(history=HistoryPolicy.KEEP_ALL)"): "keep_all",
    publisher("QoSProfile(history=QoSHistoryPolicy.KEEP_LAST, depth=2)"): "depth 2",
    publisher("QoSProfile(HistoryPolicy.KEEP_LAST, 2)"): "depth 2",
    publisher(f"QoSProfile(depth=1, reliability={BEST})"): "best_effort, depth 1",
    publisher("QoSProfile(depth=1, reliability=2)"): "best_effort, depth 1",
    publisher("rclpy.qos.QoSProfile(depth=1, reliability=rclpy.qos.ReliabilityPolicy(2))"): (
        "volatile, depth 1"
    ),
    publisher(
        "QoSProfile(depth=1, durability="
        "QoSDurabilityPolicy.RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL)"
    ): "latched",
    publisher(
        "QoSProfile(depth=1, reliability=QoSReliabilityPolicy.get_from_short_key('best_effort'))"
    ): "best_effort, depth 1",
    publisher("QoSProfile(depth=1, deadline=Duration(seconds=1))"): "depth 1, deadline 1",
    publisher("QoSProfile(depth=1, lifespan=Duration(nanoseconds=500000000))"): (
        "depth 1, lifespan 0.5"
    ),
    publisher("QoSProfile(depth=1, deadline=Duration(seconds=1, nanoseconds=5e8))"): (
        "depth 1, deadline 1.5"
    ),
    publisher("QoSProfile(depth=1, deadline=Duration(seconds=2.01))"): "depth 1, deadline 2.01",
    publisher("QoSProfile(depth=1, deadline=Duration())"): "depth 1",
    publisher("QoSProfile(depth=1, deadline=Infinite)"): "depth 1",
    publisher(
        "QoSProfile(depth=1, liveliness=LivelinessPolicy.MANUAL_BY_TOPIC, "
        "liveliness_lease_duration=Duration(seconds=2))"
    ): "depth 1, manual_by_topic, lease 2",
    publisher("copy.copy(qos_profile_sensor_data)"): "sensor_data",
    publisher("10 if self.count_publishers('a') else 10"): "depth 10",
    publisher("10 if self.count_publishers('a') else qos_profile_sensor_data"): "volatile",
    publisher("None or 4"): "depth 4",
    # Names, and attributes.
    node(f"qos = QoSProfile(depth=1)\n{USE}"): "depth 1",
    node(f"depth = 2\nqos = QoSProfile(depth=depth)\n{USE}"): "depth 2",
    node(f"how = {BEST}\nqos = QoSProfile(depth=2, reliability=how)\n{USE}"): (
        "best_effort, depth 2"
    ),
    node(PUBLISH.format("QOS"), "QOS = QoSProfile(depth=1)"): "depth 1",
    node(PUBLISH.format("DEPTH"), "DEPTH = 4"): "depth 4",
    node(USE_OF_SELF, rest="qos = qos_profile_sensor_data\n\n"): "sensor_data",
    node(PUBLISH.format("Talker.QOS"), rest="QOS = 3\n\n"): "depth 3",
    node(f"self.qos = QoSProfile(depth=1)\n{OTHER}"): "depth 1",
    node(PUBLISH.format("QOS['fast']"), "QOS = {'fast': 1, 'slow': 9}"): ("depth 1"),
    node(PUBLISH.format("QOS.get('slow')"), "QOS = {'fast': 1, 'slow': 9}"): ("depth 9"),
    node(PUBLISH.format("make()"), MAKE.format("")): ("depth 6"),
    node(
        "self.create_publisher(String, 'a', make())",
        MAKE.format(f"    qos.reliability = {BEST}\n"),
    ): "best_effort, depth 6",
    node("for qos in (3,):\n    " + USE): "depth 3",
    node("for qos in (3, 4):\n    " + USE): "",
    node(f"self.add(5)\n\ndef add(self, qos):\n    {USE}"): "depth 5",
    node(f"self.add(5)\nself.add(6)\n\ndef add(self, qos):\n    {USE}"): "",
    node(USE, given=", qos=8") + MADE.format(""): "depth 8",
    node(USE, given=", qos=8") + MADE.format("9"): "depth 9",
    # What is set later.
    node(f"qos = QoSProfile(depth=1)\nqos.{KEPT}\n{USE}"): "latched",
    node(f"qos = QoSProfile(depth=1)\nqos.depth = 2\nqos.depth = 3\n{USE}"): "depth 3",
    node(f"qos = QoSProfile(depth=1)\n{USE}\nqos.depth = 3"): "depth 1",
    node(f"qos = QoSProfile(depth=1)\nif self:\n    qos.depth = 3\n{USE}"): "",
    node(f"qos = QoSProfile(depth=1)\nif self:\n    qos.depth = 1\n{USE}"): "depth 1",
    node(f"qos = QoSProfile(depth=1)\nqos.depth += 1\n{USE}"): "",
    node(f"qos = QoSProfile(depth=1)\nwhile self:\n    {USE}\n    qos.depth = 3"): "",
    node(f"while self:\n    qos = QoSProfile(depth=1)\n    {USE}\n    qos.depth = 3"): "depth 1",
    node(f"qos = QoSProfile(depth=1)\nother = qos\nother.depth = 3\n{USE}"): "depth 3",
    node(f"qos = copy.deepcopy(qos_profile_sensor_data)\nqos.depth = 1\n{USE}"): (
        "best_effort, depth 1"
    ),
    node(f"qos_profile_sensor_data.depth = 1\nqos = qos_profile_sensor_data\n{USE}"): (
        "best_effort, depth 1"
    ),
    node(f"self.qos = QoSProfile(depth=1)\nself.qos.{KEPT}\n{OTHER}"): "latched",
    node(f"self.qos = QoSProfile(depth=1)\n{OTHER}\n\ndef late(self):\n    self.qos.depth = 3"): "",
    node(f"self.qos = QoSProfile(depth=1)\n{SET}"): "depth 3",
    node(PUBLISH.format("QOS"), "QOS = QoSProfile(depth=1)\nQOS.depth = 2"): ("depth 2"),
}


def qos_in(text: str) -> list[Qos | None]:
    source = read_python(Path("node.py"), one(text.encode())).source
    assert source is not None
    return [found.qos for found in source.endpoints if found.type is not None]


@pytest.mark.parametrize("text", FORMS)
def test_what_a_publisher_of_rclpy_has(text: str) -> None:
    (qos,) = qos_in(text)
    assert qos is not None
    assert text_of(qos) == FORMS[text]


UNKNOWN = [
    publisher("self.declare_parameter('depth', 10).value"),
    publisher("QoSPresetProfiles.SENSOR_DATA"),
    publisher("their_profile"),
    publisher("make()"),
    publisher("QoSProfile"),
    publisher("10.5"),
    publisher("'10'"),
    publisher("*[10]"),
    node("self.create_publisher(String, 'a')"),
    publisher("10, qos_overriding_options=QoSOverridingOptions.with_default_policies()"),
    # Another file may give another value, or none does.
    node(USE, given=", qos=8"),
    node(USE, given=", qos"),
    node(f"self.add(*self.given)\n\ndef add(self, qos=5):\n    {USE}"),
    publisher("10 if self else their_profile"),
    node(f"self.qos = copy.copy(self.qos)\n{USE_OF_SELF}"),
    node(f"qos = qos\n{USE}"),
    node(f"import their\nqos = their.QoSProfile(depth=1)\n{USE}"),
    node(f"qos = 10\nif self:\n    qos = self.get()\n{USE}"),
]


@pytest.mark.parametrize("text", UNKNOWN)
def test_what_no_file_says_is_not_known(text: str) -> None:
    assert qos_in(text) == [None]


PARTS = {
    "depth=self.depth": DEFAULT._replace(depth=None),
    "depth=2, reliability=self.how": DEFAULT._replace(depth=2, reliability=None),
    "depth=2, reliability=DurabilityPolicy.VOLATILE": DEFAULT._replace(depth=2, reliability=None),
    "depth=2, deadline=Duration(seconds=self.slow)": DEFAULT._replace(depth=2, deadline=None),
    "depth=2, deadline=Duration(seconds=-1)": DEFAULT._replace(depth=2, deadline=None),
    "depth=2, deadline=1": DEFAULT._replace(depth=2, deadline=None),
    "depth=2, reliability=ReliabilityPolicy.BEST_AVAILABLE": DEFAULT._replace(
        depth=2, reliability="best_available"
    ),
    "depth=2, durability=DurabilityPolicy.UNKNOWN": DEFAULT._replace(depth=2, durability=None),
    "depth=2, **more": Qos(depth=2),
}


@pytest.mark.parametrize("given", PARTS)
def test_a_policy_that_no_file_says_leaves_the_others_known(given: str) -> None:
    assert qos_in(publisher(f"QoSProfile({given})")) == [PARTS[given]]


OTHERS = {
    "self.create_subscription(String, 'a', print, 3)": DEFAULT._replace(depth=3),
    "self.create_subscription(String, 'a', print, qos_profile=3)": DEFAULT._replace(depth=3),
    "self.create_lifecycle_publisher(String, 'a', 3)": DEFAULT._replace(depth=3),
    "self.create_service(Trigger, 'a', print)": None,
    "message_filters.Subscriber(self, String, 'a')": DEFAULT,
    "message_filters.Subscriber(self, String, 'a', qos_profile=qos_profile_sensor_data)": PROFILES[
        "sensor_data"
    ],
    "wait_for_message(String, self, 'a')": DEFAULT._replace(depth=1),
    "tf2_ros.StaticTransformBroadcaster(self)": DEFAULT._replace(
        depth=1, durability="transient_local"
    ),
    "tf2_ros.TransformBroadcaster(self, 5)": DEFAULT._replace(depth=5),
}


@pytest.mark.parametrize("call", OTHERS)
def test_other_calls_of_rclpy(call: str) -> None:
    module = (
        "import message_filters, tf2_ros\nfrom rclpy.wait_for_message import wait_for_message\n"
        "from std_srvs.srv import Trigger"
    )
    assert qos_in(node(call, module)) == [OTHERS[call]]


def test_a_listener_of_transforms_waits_for_what_was_sent_once() -> None:
    text = node("tf2_ros.TransformListener(self.buffer, self)", "import tf2_ros")
    assert [qos and qos.durability for qos in qos_in(text)] == ["volatile", "transient_local"]


RELIABLE = Qos("reliable", "volatile")
ROSPY = {
    "rospy.Publisher('a', String, queue_size=3)": RELIABLE._replace(history="keep_last", depth=3),
    "rospy.Publisher('a', String, queue_size=0)": RELIABLE._replace(history="keep_all"),
    "rospy.Publisher('a', String, queue_size=None)": RELIABLE,
    "rospy.Publisher('a', String)": RELIABLE,
    "rospy.Publisher('a', String, latch=True)": Qos("reliable", "transient_local"),
    "rospy.Publisher('a', String, latch=False)": RELIABLE,
    "rospy.Publisher('a', String, latch=LATCH)": Qos("reliable", "transient_local"),
    "rospy.Publisher('a', String, latch=unknown)": Qos("reliable"),
    "rospy.Publisher('a', String, None, False, True, None, 3)": Qos(
        "reliable", "transient_local", "keep_last", 3
    ),
    "rospy.Subscriber('a', String, print, queue_size=3)": Qos(history="keep_last", depth=3),
    "rospy.Subscriber('a', String, print, None, 3)": Qos(history="keep_last", depth=3),
    "rospy.Subscriber('a', String, print)": None,
    "message_filters.Subscriber('a', String, queue_size=3)": Qos(history="keep_last", depth=3),
}


@pytest.mark.parametrize("call", ROSPY)
def test_calls_of_rospy(call: str) -> None:
    head = "import message_filters, rospy\nfrom std_msgs.msg import String\nLATCH = True\n"
    assert qos_in(f"{head}{call}\n") == [ROSPY[call]]


def test_profiles_of_another_file_of_the_package(tmp_path: Path) -> None:
    (tmp_path / "profiles.py").write_text(
        "from rclpy.qos import QoSProfile, qos_profile_sensor_data as SENSORS\n"
        "FAST = QoSProfile(depth=1)\nFAST.depth = 2\nSLOW = FAST\nDEPTH = 7\n"
        "def make():\n    return FAST\n"
    )
    names = {"FAST": "depth 2", "SLOW": "depth 2", "SENSORS": "sensor_data", "DEPTH": "depth 7"}
    for name, text in names.items():
        path = tmp_path / "talker.py"
        found = node(f"self.create_publisher(String, 'a', {name})", "from profiles import *")
        for each in (found, found.replace("import *", f"import {name}")):
            source = read_python(path, one(each.encode())).source
            assert source is not None
            (endpoint,) = source.endpoints
            assert endpoint.qos is not None
            assert text_of(endpoint.qos) == text


def test_calls_of_one_name_that_differ_have_the_rest_in_common() -> None:
    text = node(
        f"self.add(5, 'a')\nself.add(6, 'a')\nself.add(7, 'b')\n\n"
        f"def add(self, qos, name):\n    {USE.replace(repr('a'), 'name')}"
    )
    assert qos_in(text) == [DEFAULT._replace(depth=None), DEFAULT._replace(depth=7)]


def test_what_inspect_shows() -> None:
    text = publisher("QoSProfile(depth=1, deadline=Duration(seconds=2), reliability=self.how)")
    source = read_python(Path("node.py"), one(text.encode())).source
    assert source is not None
    assert "std_msgs/String with qos volatile, depth 1, deadline 2" in inspect_text(source)
    (shown,) = inspect_json(source)["nodes"][0]["publishers"]
    assert shown["qos"] == {
        "durability": "volatile",
        "history": "keep_last",
        "depth": 1,
        "deadline": 2.0,
        "lifespan": "infinite",
        "liveliness": "system_default",
        "lease": "infinite",
    }


def test_a_profile_that_changes_too_often_is_not_known() -> None:
    changes = "".join(f"qos.depth = {depth}\n{USE}\n" for depth in range(1, 40))
    assert set(qos_in(node(f"qos = QoSProfile(depth=1)\n{changes}"))) == {None}
