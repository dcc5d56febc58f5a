"""What is written for each part of a node, and what is refused."""

from __future__ import annotations

from pathlib import Path

import pytest
from file_sets import one
from made_nodes import SPAN, catalog
from templates_here import render_here

from plastron_tui.model.kinds import (
    ActionClient,
    ActionServer,
    Client,
    Message,
    Parameter,
    Publication,
    Publisher,
    Rate,
    Request,
    Service,
    Subscription,
)
from plastron_tui.model.values import Computed, MessageValue, OfParameter, Value
from plastron_tui.model.workspace import Node
from plastron_tui.ros.interfaces import FieldType, InterfaceName
from plastron_tui.ros.parameters import ParameterType
from plastron_tui.session import Session
from plastron_tui.targets import find_target
from plastron_tui.targets.base import Rendered
from plastron_tui.targets.python.rclpy import RclpyTarget
from plastron_tui.targets.python.rospy import RospyTarget

STRING = InterfaceName("std_msgs", "String")


def render(node: Node, library: str, templates: Path | None = None) -> Rendered:
    target = find_target(library, templates)
    assert target is not None
    return target.render(node, catalog(library))


def text(node: Node, library: str) -> str:
    rendered = render(node, library)
    assert rendered.files is not None, rendered.diagnostics
    return rendered.files.main.decode()


def new() -> Node:
    return Node("robot", "robot", SPAN)


def publishing(type_: str, *sent: tuple[dict[str, Value], float]) -> Node:
    name = InterfaceName(*type_.split("/"))
    node = new()
    publications = tuple(
        Publication(Message("m", MessageValue(name, fields), SPAN), rate) for fields, rate in sent
    )
    node.put(Publisher("out", name, publications, SPAN))
    return node


VALUES: list[tuple[str, str, dict[str, Value], str]] = [
    ("rospy", "std_msgs/Float64", {"data": 5.0}, "Float64(data=5.0)"),
    ("rclpy", "std_msgs/Float64", {"data": 5.0}, "Float64(data=5.0)"),
    ("rospy", "std_msgs/Float64", {"data": 1e16}, "Float64(data=1e16)"),
    ("rospy", "std_msgs/Byte", {"data": -5}, "Byte(data=-5)"),
    ("rclpy", "std_msgs/Byte", {"data": 5}, r'Byte(data=b"\x05")'),
    ("rclpy", "std_msgs/Byte", {"data": 34}, "Byte(data=b'\"')"),
    ("rclpy", "std_msgs/Byte", {"data": 92}, r'Byte(data=b"\\")'),
    ("rclpy", "std_msgs/Byte", {"data": 255}, r'Byte(data=b"\xff")'),
    ("rclpy", "std_msgs/Char", {"data": 65}, "Char(data=65)"),
    ("rospy", "std_msgs/Bool", {"data": True}, "Bool(data=True)"),
    ("rospy", "std_msgs/Time", {"data": (1, 2)}, "Time(data=rospy.Time(1, 2))"),
    ("rospy", "std_msgs/Duration", {"data": (-1, 2)}, "Duration(data=rospy.Duration(-1, 2))"),
    ("rospy", "std_msgs/UInt8MultiArray", {"data": (1, 2)}, "UInt8MultiArray(data=[1, 2])"),
    (
        "rclpy",
        "std_msgs/ByteMultiArray",
        {"data": (1, 2)},
        r'ByteMultiArray(data=[b"\x01", b"\x02"])',
    ),
    ("rospy", "std_msgs/String", {"data": 'a "b"\n'}, "String(data='a \"b\"\\n')"),
    ("rospy", "std_msgs/String", {"data": "é \u202e"}, 'String(data="é \\u202e")'),
    ("rospy", "geometry_msgs/Point", {}, "Point()"),
]


@pytest.mark.parametrize(("library", "type_", "fields", "expected"), VALUES)
def test_a_value_is_written_as_its_library_takes_it(
    library: str, type_: str, fields: dict[str, Value], expected: str
) -> None:
    assert f"        message = {expected}\n" in text(publishing(type_, (fields, 10.0)), library)


# What is heard, what is sent of it and when, and what is written.
CALCULATED = [
    ("rospy", "Float64", "Float64", "* 2", "> 0", "Float64(data=received.data * 2)"),
    ("rclpy", "Float64", "Float64", "* 2", "> 0", "Float64(data=received.data * 2)"),
    ("rclpy", "Int32", "Float64", "+ 1", "> 0", "Float64(data=float(received.data + 1))"),
    ("rclpy", "Float64", "Float32", "* 2", "> 0", "as_float32(received.data * 2)"),
    ("rospy", "Byte", "Int32", "+ 1", "> 0", "if received.data > 0:"),
    ("rclpy", "Byte", "Int32", "+ 1", "> 0", "if received.data[0] > 0:"),
    ("rclpy", "UInt8", "Int32", "+ 1", "> 0", "if received.data > 0:"),
    ("rospy", "ByteMultiArray", "Int32", "[0] + 1", "= 2", "any(each == 2 for"),
    ("rclpy", "ByteMultiArray", "Int32", "[0] + 1", "= 2", "any(each[0] == 2 for"),
]


@pytest.mark.parametrize(("library", "heard", "sent", "steps", "compared", "written"), CALCULATED)
def test_what_is_received_is_calculated_and_compared_as_a_number(
    library: str, heard: str, sent: str, steps: str, compared: str, written: str
) -> None:
    each = "any " if heard.endswith("Array") else ""
    program = (
        f"create_node 'n' as n using {library}\n"
        f"subscribe n to 'a' of message_type std_msgs/{heard}\n"
        f"create_message m of message_type std_msgs/{sent} and input received.data{steps}\n"
        f"n publish m to 'b' of message_type std_msgs/{sent} for_each 'a' "
        f"when {each}received.data {compared}\n"
    )
    session = Session(program.encode())
    assert not session.diagnostics
    [node] = session.workspace.nodes.values()
    assert written in text(node, library)


def test_one_publisher_sends_both_messages_of_a_topic() -> None:
    source = text(publishing("std_msgs/Int8", ({"data": 1}, 10.0), ({"data": 2}, 10.0)), "rospy")
    assert source.count("rospy.Publisher(") == source.count("rospy.Timer(") == 1
    assert source.count("self.out_publisher.publish(message)") == 2


def test_messages_of_two_rates_have_a_timer_each() -> None:
    source = text(publishing("std_msgs/Int8", ({"data": 1}, 10.0), ({"data": 2}, 0.5)), "rclpy")
    assert source.count("self.create_publisher(") == 1
    assert "self.create_timer(1 / 10, self.publish_out)" in source
    assert "self.create_timer(1 / 0.5, self.publish_out_2)" in source


@pytest.mark.parametrize(
    ("library", "now"),
    [("rospy", "rospy.Time.now()"), ("rclpy", "self.get_clock().now().to_msg()")],
)
def test_a_header_without_a_time_is_stamped(library: str, now: str) -> None:
    stamped = f"message.header.stamp = {now}\n"
    frame = MessageValue(InterfaceName("std_msgs", "Header"), {"frame_id": "map"})
    assert stamped in text(publishing("geometry_msgs/PointStamped", ({}, 1.0)), library)
    named = publishing("geometry_msgs/PointStamped", ({"header": frame}, 1.0))
    assert stamped in text(named, library)


def test_a_time_that_was_given_stays() -> None:
    header = MessageValue(InterfaceName("std_msgs", "Header"), {"stamp": (1, 2)})
    source = text(publishing("geometry_msgs/PointStamped", ({"header": header}, 1.0)), "rospy")
    assert "Header(stamp=rospy.Time(1, 2))" in source
    assert "Time.now" not in source


def test_callbacks_have_names_of_their_own() -> None:
    node = new()
    for topic in ("arm/x", "arm_x", "/arm/x", "1st", "~class", "given"):
        node.put(Subscription(topic, STRING, None, SPAN))
    node.put(Subscription("given", STRING, "on_arm_x", SPAN))
    source = text(node, "rospy")
    for name in ("on_arm_x", "on_arm_x_2", "on_arm_x_3", "on_arm_x_4", "on_number_1st", "on_class"):
        assert source.count(f"def {name}(self, message):") == 1
    assert 'rospy.Subscriber("given", String, self.on_arm_x)' in source


def test_two_subscriptions_may_share_a_callback() -> None:
    node = new()
    for topic in ("a", "b"):
        node.put(Subscription(topic, STRING, "hear", SPAN))
    source = text(node, "rclpy")
    assert source.count("def hear(self, message):") == 1
    assert source.count("self.hear, 10)") == 2


def test_types_of_one_name_are_told_apart() -> None:
    node = new()
    node.put(Subscription("a", InterfaceName("std_msgs", "Empty"), None, SPAN))
    node.put(Service("b", InterfaceName("std_srvs", "Empty"), None, SPAN))
    source = text(node, "rospy")
    assert "from std_msgs.msg import Empty as StdMsgsEmpty\n" in source
    assert "from std_srvs.srv import Empty as StdSrvsEmpty\n" in source
    assert 'rospy.Subscriber("a", StdMsgsEmpty, self.on_a)' in source
    assert 'rospy.Service("b", StdSrvsEmpty, self.handle_b)' in source


SET_BOOL = InterfaceName("std_srvs", "SetBool")
SET = MessageValue(SET_BOOL, {"data": True})
FIBONACCI = InterfaceName("example_interfaces", "Fibonacci")
CALL, CALL_AGAIN = Request(SET), Request(SET, Rate(5.0))


def calling(*requests: Request) -> Node:
    node = new()
    node.put(Client("set", SET_BOOL, requests, SPAN))
    return node


def asking(*others: Publisher | ActionServer) -> Node:
    node = new()
    goal = MessageValue(FIBONACCI, {"order": 5})
    node.put(ActionClient("count", FIBONACCI, (goal, goal), SPAN))
    for each in others:
        node.put(each)
    return node


ENDING = [
    (calling(CALL, CALL), True),
    (calling(CALL_AGAIN), False),
    (calling(CALL, CALL_AGAIN), False),
    (asking(), True),
    (asking(Publisher("out", STRING, (), SPAN)), False),
    (asking(ActionServer("other", FIBONACCI, None, SPAN)), False),
]


@pytest.mark.parametrize("library", ["rospy", "rclpy"])
@pytest.mark.parametrize(("node", "ends"), ENDING)
def test_a_node_ends_that_has_nothing_more_to_do(library: str, node: Node, ends: bool) -> None:
    source = text(node, library)
    assert ("spin(" not in source) == ends
    assert ("sys.exit(node.exit_status)" in source) == ends
    assert ("def fail(" in source) == ends


def test_every_request_and_goal_is_sent() -> None:
    for library in ("rospy", "rclpy"):
        assert text(calling(CALL, CALL), library).count("self.call(self.set_client, SetBool") == 2
        assert text(asking(), library).count('self.send_goal("count", self.count_client, ') == 2


def test_a_type_that_was_renamed_has_its_name_of_the_distribution() -> None:
    node = new()
    old = InterfaceName("beginner_tutorials", "AddTwoInts")
    node.put(Service("add", old, None, SPAN))
    assert "from beginner_tutorials.srv import AddTwoInts" in text(node, "rospy")
    assert "from example_interfaces.srv import AddTwoInts\n" in text(node, "rclpy")


def with_subscription(type_: InterfaceName | None, callback: str | None = None) -> Node:
    node = new()
    node.put(Subscription("in", type_, callback, SPAN))
    return node


def with_shared_handler() -> Node:
    node = with_subscription(STRING, "both")
    type_ = InterfaceName("std_srvs", "Empty")
    node.put(Service("s", type_, "both", SPAN))
    return node


SEQ = MessageValue(InterfaceName("std_msgs", "Header"), {"seq": 1})
REFUSED = [
    ("rospy", with_subscription(InterfaceName("no_such_msgs", "Thing")), "unknown-type"),
    ("rclpy", with_subscription(InterfaceName("std_msgs", "Time2")), "unknown-type"),
    ("rospy", with_subscription(None), "unknown-type"),
    ("rospy", with_subscription(STRING, "class"), "invalid-function"),
    ("rospy", with_subscription(STRING, "follow_rates"), "invalid-function"),
    ("rclpy", asking(ActionServer("other", FIBONACCI, "sleep", SPAN)), "invalid-function"),
    ("rospy", asking(ActionServer("other", FIBONACCI, "work", SPAN)), "invalid-function"),
    ("rclpy", with_subscription(STRING, "get_logger"), "invalid-function"),
    ("rclpy", with_subscription(STRING, "_clients"), "invalid-function"),
    ("rospy", with_subscription(STRING, "__init__"), "invalid-function"),
    ("rclpy", with_subscription(STRING, "__del__"), "invalid-function"),
    ("rclpy", with_shared_handler(), "invalid-function"),
    ("rclpy", publishing("std_msgs/Header", (SEQ.fields, 10.0)), "unknown-field"),
]


@pytest.mark.parametrize(("library", "node", "code"), REFUSED)
def test_what_a_library_cannot_have_is_a_diagnostic(library: str, node: Node, code: str) -> None:
    rendered = render(node, library)
    assert rendered.files is None
    assert [each.code for each in rendered.diagnostics] == [code]
    assert rendered.diagnostics[0].span == SPAN


def test_a_note_says_what_became_of_a_field() -> None:
    rendered = render(publishing("std_msgs/Header", (SEQ.fields, 10.0)), "rclpy")
    assert "no `seq`" in (rendered.diagnostics[0].help or "")


def test_a_users_template_comes_first(tmp_path: Path) -> None:
    folder = tmp_path / "rospy"
    folder.mkdir()
    (folder / "node.py.j2").write_text("name = {{ node.name }}\n")
    node = with_subscription(STRING)
    assert render(node, "rospy", tmp_path).files == one(b'name = "robot"\n')
    assert render(node, "rclpy", tmp_path).files == one(text(node, "rclpy").encode())


@pytest.mark.parametrize(
    "template",
    [
        "{{ node.nothing }}",
        "{% for %}",
        "{% include 'x.j2' %}",
        "{{ 1 / 0 }}",
        "{{ node.name + 1 }}",
        "{% macro again() %}{{ again() }}{% endmacro %}{{ again() }}",
        "{{ cycler.__init__.__globals__.os.getcwd() }}",
        "{{ ''.__class__.__mro__ }}",
    ],
)
def test_a_broken_template_is_a_diagnostic(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, template: str
) -> None:
    render_here(monkeypatch)
    folder = tmp_path / "rospy"
    folder.mkdir()
    (folder / "node.py.j2").write_text(template)
    rendered = render(with_subscription(STRING), "rospy", tmp_path)
    assert rendered.files is None
    assert [each.code for each in rendered.diagnostics] == ["template-error"]


@pytest.mark.parametrize(
    ("library", "second", "written"),
    [
        ("rospy", "a/b", "data=self.get_a_b_2()"),
        ("rclpy", "a.b", 'data=self.get_parameter("a.b").value'),
    ],
)
def test_each_of_two_names_that_are_alike_in_words_is_read(
    library: str, second: str, written: str
) -> None:
    double = FieldType("float64")
    value = Computed(OfParameter(second), (), double, is_float=True)
    node = publishing("std_msgs/Float64", ({"data": value}, 4.0))
    for name in ("a_b", second):
        name = f"~/{name}" if library == "rospy" else name
        node.put(Parameter(name, None, ParameterType.FLOAT, 1.0, span=SPAN))
    assert written in text(node, library)


def test_targets_are_found_by_name() -> None:
    assert isinstance(find_target("rospy"), RospyTarget)
    assert isinstance(find_target("rclpy"), RclpyTarget)
    assert find_target("no_such_library") is None


@pytest.mark.parametrize(("library", "written"), [("rospy", '"~x"'), ("rclpy", '"~/x"')])
def test_a_private_name_is_written_as_its_library_takes_it(library: str, written: str) -> None:
    node = new()
    node.put(Subscription("~/x", STRING, None, SPAN))
    assert written in text(node, library)
