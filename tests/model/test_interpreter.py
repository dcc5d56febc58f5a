from __future__ import annotations

import pytest
from workspaces import FakeReader, codes, endpoint, marked, run, source, workspace

from plastron_tui.diagnostics import Severity
from plastron_tui.model.source import EndpointKind
from plastron_tui.model.values import MessageValue
from plastron_tui.model.workspace import DEFAULT_RATE
from plastron_tui.ros.interfaces import InterfaceName

STRING = InterfaceName("std_msgs", "String")
NODE = "create_node 'talker' as n\n"
MESSAGE = 'create_message m of message_type String and input "hi"\n'
TALKER = NODE + MESSAGE + "n publish m to 'chatter' of message_type String\n"


def test_create_node() -> None:
    nodes = workspace(NODE + "create_node 'other' as o using rclpy\n").nodes
    assert [(node.name, node.variable, node.library) for node in nodes.values()] == [
        ("talker", "n", None),
        ("other", "o", "rclpy"),
    ]
    assert nodes["n"].is_idle
    assert nodes["n"].source is None


def test_create_message() -> None:
    message = workspace(MESSAGE).messages["m"]
    assert message.value == MessageValue(STRING, {"data": "hi"})
    assert message.span == (0, len(MESSAGE) - 1)


def test_publish_and_its_rate() -> None:
    text = TALKER + "n publish m to '/fast' of message_type std_msgs/String at 50 hz\n"
    publishers = workspace(text).nodes["n"].publishers
    assert list(publishers) == ["chatter", "/fast"]
    assert [each.type for each in publishers.values()] == [STRING, STRING]
    rates = [pub.rate for each in publishers.values() for pub in each.publications]
    assert rates == [DEFAULT_RATE, 50.0]
    assert all(isinstance(rate, float) for rate in rates)


def test_two_messages_to_one_topic_make_one_publisher() -> None:
    text = (
        TALKER
        + 'create_message m2 of message_type String and input "ho"\n'
        + "n publish m2 to 'chatter' of message_type String at 2 hz\n"
    )
    (publisher,) = workspace(text).nodes["n"].publishers.values()
    sent = [(each.message.variable, each.rate) for each in publisher.publications]
    assert sent == [("m", 10.0), ("m2", 2.0)]


def test_stop_publishing_takes_all_messages_away() -> None:
    text = TALKER + "n stop_publishing to 'chatter'\n"
    node = workspace(text).nodes["n"]
    assert node.publishers == {}
    assert text.encode()[node.removed["chatter"].start :].startswith(b"n stop_publishing")
    assert codes(text + "generate_node n\n") == ["idle-node"]


def test_subscribe_and_unsubscribe() -> None:
    text = (
        NODE
        + "subscribe n to 'a' of message_type String\n"
        + "subscribe n to 'b' of message_type Int32 calling on_b\n"
    )
    listeners = workspace(text).nodes["n"].subscriptions
    assert [(each.topic, each.callback) for each in listeners.values()] == [
        ("a", None),
        ("b", "on_b"),
    ]
    left = workspace(text + "unsubscribe n from 'a'\n").nodes["n"].subscriptions
    assert list(left) == ["b"]


def test_services_and_clients() -> None:
    text = (
        NODE
        + "n provides_service 's' of service_type Trigger\n"
        + "n provides_service 't' of service_type SetBool calling do_t\n"
        + "n client_requests 'add' of service_type AddTwoInts with input 5, 6\n"
        + "n client_requests 'add' of service_type AddTwoInts with input b=1\n"
        + "n client_requests 'w' of service_type WaypointClear with input none\n"
    )
    node = workspace(text).nodes["n"]
    assert [(each.name, each.handler) for each in node.services.values()] == [
        ("s", None),
        ("t", "do_t"),
    ]
    add = node.clients["add"]
    assert add.type == InterfaceName("beginner_tutorials", "AddTwoInts")
    assert [request.fields for request in add.requests] == [{"a": 5, "b": 6}, {"b": 1}]
    assert [request.fields for request in node.clients["w"].requests] == [{}]
    left = workspace(text + "n stop_service 's'\nn stop_request 'add'\n").nodes["n"]
    assert (list(left.services), list(left.clients)) == (["t"], ["w"])


def test_endpoints_keep_the_order_of_the_program() -> None:
    names = ["z", "a", "m", "b"]
    text = NODE + "".join(f"subscribe n to '{name}' of message_type String\n" for name in names)
    assert list(workspace(text).nodes["n"].subscriptions) == names
    again = text + "unsubscribe n from 'a'\nsubscribe n to 'a' of message_type String\n"
    assert list(workspace(again).nodes["n"].subscriptions) == ["z", "m", "b", "a"]


def test_a_generation_is_the_node_as_it_was() -> None:
    text = (
        TALKER
        + "generate_node n\n"
        + "n stop_publishing to 'chatter'\n"
        + "subscribe n to 'a' of message_type String\n"
        + "generate_node n using rclpy\n"
    )
    first, second = workspace(text).generations
    assert (first.library, second.library) == ("rospy", "rclpy")
    assert (list(first.node.publishers), list(first.node.subscriptions)) == (["chatter"], [])
    assert (list(second.node.publishers), list(second.node.subscriptions)) == ([], ["a"])


@pytest.mark.parametrize(
    ("default", "created", "generated", "expected"),
    [
        ("rospy", "", "", "rospy"),
        ("rclpy", "", "", "rclpy"),
        ("rospy", " using rclpy", "", "rclpy"),
        ("rospy", " using rclpy", " using rclcpp", "rclcpp"),
        ("rclpy", "", " using rospy", "rospy"),
    ],
)
def test_the_client_library(default: str, created: str, generated: str, expected: str) -> None:
    text = (
        f"create_node 'a' as n{created}\n"
        "subscribe n to 'a' of message_type String\n"
        f"generate_node n{generated}\n"
    )
    assert workspace(text, default).generations[0].library == expected


def test_the_distribution_of_a_node_decides_what_a_name_means() -> None:
    text = (
        "create_node 'a' as a using rospy\n"
        "create_node 'b' as b using rclpy\n"
        "a provides_service 'add' of service_type AddTwoInts\n"
        "b provides_service 'add' of service_type AddTwoInts\n"
    )
    nodes = workspace(text).nodes
    packages = [nodes[key].services["add"].type for key in "ab"]
    assert [type_ and type_.package for type_ in packages] == [
        "beginner_tutorials",
        "example_interfaces",
    ]


@pytest.mark.parametrize("default", ["rospy", "rclpy"])
def test_a_message_is_fitted_to_the_ros_of_each_node_that_sends_it(default: str) -> None:
    text = (
        "create_message h of message_type std_msgs/Header and input stamp=1.5\n"
        "create_node 'a' as a using rospy\n"
        "create_node 'b' as b using rclpy\n"
        "a publish h to 't' of message_type std_msgs/Header\n"
        "b publish h to 't' of message_type std_msgs/Header\n"
    )
    nodes = workspace(text, default).nodes
    stamps = [nodes[key].publishers["t"].publications[0].message.value for key in "ab"]
    assert stamps[0].fields == {"stamp": (1, 500_000_000)}
    time = MessageValue(
        InterfaceName("builtin_interfaces", "Time"), {"sec": 1, "nanosec": 500_000_000}
    )
    assert stamps[1].fields == {"stamp": time}


def test_a_message_that_only_the_other_ros_has() -> None:
    text = (
        "create_message m of message_type action_msgs/GoalStatus and input status=2\n"
        "create_node 'b' as b using rclpy\n"
        "b publish m to 't' of message_type action_msgs/GoalStatus\n"
    )
    assert codes(text) == []
    assert codes(text.replace(" using rclpy", "")) == ["unknown-type"]


def test_a_message_that_does_not_fit_the_other_ros_is_one_mistake() -> None:
    text = (
        "create_message h of message_type std_msgs/Header and input seq=1\n"
        "create_node 'b' as b using rclpy\n"
        "b publish h to 't' of message_type std_msgs/Header\n"
        "b publish h to 'u' of message_type std_msgs/Header\n"
        "generate_node b\n"
    )
    found = run(text).diagnostics
    assert [(each.code, marked(text, each)) for each in found] == [("unknown-field", "seq")]


TYPE_CONFLICTS = {
    ("x", "/x"): True,
    ("/x", "x"): True,
    ("~x", "/first/x"): True,
    ("~/x", "first/x"): True,
    ("~x", "~x"): False,
    ("x", "y"): False,
    ("a/x", "/a/x"): True,
}


@pytest.mark.parametrize(("names", "conflict"), TYPE_CONFLICTS.items())
def test_one_topic_has_one_type(names: tuple[str, str], conflict: bool) -> None:
    text = (
        "create_node 'first' as a\ncreate_node 'second' as b\n"
        f"subscribe a to '{names[0]}' of message_type String\n"
        f"subscribe b to '{names[1]}' of message_type Int32\n"
    )
    assert codes(text) == (["topic-type-conflict"] if conflict else [])
    services = text.replace("subscribe a to", "a provides_service").replace(
        "subscribe b to", "b provides_service"
    )
    services = services.replace("message_type String", "service_type Empty").replace(
        "message_type Int32", "service_type Trigger"
    )
    assert codes(services) == (["service-type-conflict"] if conflict else [])


def test_a_topic_that_nobody_uses_any_more_is_free() -> None:
    text = (
        NODE
        + "create_node 'b' as b\n"
        + "subscribe n to 'x' of message_type String\n"
        + "subscribe b to 'x' of message_type String\n"
        + "unsubscribe n from 'x'\n"
    )
    again = "subscribe n to 'x' of message_type Int32\n"
    (found,) = run(text + again).diagnostics
    assert found.code == "topic-type-conflict"
    (label,) = found.labels
    assert (text + again)[label.span.start :].startswith("subscribe b to 'x'")
    assert codes(text + "unsubscribe b from 'x'\n" + again) == []


def test_a_topic_and_a_service_share_no_name() -> None:
    text = NODE + "subscribe n to 'x' of message_type String\n"
    assert codes(text + "n provides_service 'x' of service_type Trigger\n") == []


def test_two_graphs_share_no_topic() -> None:
    text = (
        "create_node 'a' as a using rospy\ncreate_node 'b' as b using rclpy\n"
        "subscribe a to 'x' of message_type String\n"
        "subscribe b to 'x' of message_type Int32\n"
    )
    assert codes(text) == []


def test_a_service_of_two_nodes_is_a_warning_and_has_its_effect() -> None:
    text = (
        NODE
        + "create_node 'b' as b\n"
        + "n provides_service 's' of service_type Trigger\n"
        + "b provides_service '/s' of service_type Trigger\n"
    )
    found = run(text)
    (warning,) = found.diagnostics
    assert (warning.code, warning.severity) == ("service-provided-twice", Severity.WARNING)
    assert marked(text, warning) == "'/s'"
    assert list(found.workspace.nodes["b"].services) == ["/s"]
    assert codes(text.replace("b provides", "n stop_service 's'\nb provides")) == []


FUNCTIONS = {
    "subscribe n to 'a' of message_type String calling f\n"
    "n provides_service 's' of service_type Trigger calling f\n": ["function-conflict"],
    "n provides_service 's' of service_type Trigger calling f\n"
    "subscribe n to 'a' of message_type String calling f\n": ["function-conflict"],
    "n provides_service 's' of service_type Trigger calling f\n"
    "n provides_service 't' of service_type SetBool calling f\n": ["function-conflict"],
    "n provides_service 's' of service_type Trigger calling f\n"
    "n provides_service 't' of service_type Trigger calling f\n": [],
    "subscribe n to 'a' of message_type String calling f\n"
    "subscribe n to 'b' of message_type String calling f\n": [],
    "subscribe n to 'a' of message_type String calling f\n"
    "unsubscribe n from 'a'\n"
    "n provides_service 's' of service_type Trigger calling f\n": [],
    "subscribe n to 'a' of message_type String calling class\n": ["invalid-function"],
    "n provides_service 's' of service_type Trigger calling None\n": ["invalid-function"],
}


@pytest.mark.parametrize(("text", "expected"), FUNCTIONS.items(), ids=range(len(FUNCTIONS)))
def test_functions(text: str, expected: list[str]) -> None:
    assert codes(NODE + text) == expected


MISTAKES: list[tuple[str, str, str, str | None]] = [
    ("create_node 'other' as n", "variable-exists", "n", "another name"),
    ("create_message n of message_type String and input none", "variable-exists", "n", None),
    ("create_node 'x' as m", "variable-exists", "m", None),
    ("load driver as n", "variable-exists", "n", None),
    ("create_node 'talker' as t", "node-exists", "'talker'", None),
    ("create_node 'x' as _x", "invalid-variable", "_x", "write `x`"),
    ("create_node 'x' as x using rospi", "unknown-library", "rospi", "did you mean `rospy`?"),
    ("create_node 'x' as x using ros2", "unknown-library", "ros2", "did you mean `rclpy`?"),
    ("create_node 'x' as x using Noetic", "unknown-library", "Noetic", "did you mean `rospy`?"),
    ("generate_node n using turtle", "unknown-library", "turtle", "rospy, rclpy"),
    ("create_node '../../x' as x", "invalid-name", "/", None),
    ("create_node '__import__(os)' as x", "invalid-name", "(", None),
    ("create_node '' as x", "invalid-name", "", None),
    ("subscribe n to 'a b' of message_type String", "invalid-name", " ", "write 'a_b'"),
    ("subscribe n to 'é' of message_type String", "invalid-name", "é", None),
    ("n provides_service 'a//b' of service_type Trigger", "invalid-name", "//", None),
    ("subscribe nn to 'a' of message_type String", "unknown-node", "nn", "did you mean `n`?"),
    ("subscribe m to 'a' of message_type String", "unknown-node", "m", "`m` is a message"),
    ("generate_node zzz", "unknown-node", "zzz", None),
    ("n publish mm to 'a' of message_type String", "unknown-message", "mm", "did you mean `m`?"),
    ("n publish n to 'a' of message_type String", "unknown-message", "n", "`n` is a node"),
    ("n publish m to 'a' of message_type Strin", "unknown-type", "Strin", "`String`"),
    ("n publish m to 'a' of message_type Int32", "message-type-mismatch", "Int32", "String"),
    ("n publish m to 'a' of message_type String at 0 hz", "invalid-rate", "0", None),
    ("n publish m to 'a' of message_type String at -1 hz", "invalid-rate", "-1", "write `at 1 hz`"),
    ("n publish m to 'a' of message_type String at 1e7 hz", "invalid-rate", "1e7", None),
    ("n publish m to 'a' of message_type String at 1e999 hz", "invalid-rate", "1e999", None),
    ("n publish m to 'a' of message_type String at 1e-999 hz", "invalid-rate", "1e-999", None),
    ("n publish m to 'chatter' of message_type String", "already-publishing", "'chatter'", None),
    ("n stop_publishing to 'chater'", "not-publishing", "'chater'", "did you mean `chatter`?"),
    ("unsubscribe n from 'chatter'", "not-subscribed", "'chatter'", None),
    ("n stop_service 's'", "not-providing", "'s'", None),
    ("n stop_request 's'", "not-requesting", "'s'", None),
    ("subscribe n to 'chatter' of message_type Int32", "topic-type-conflict", "Int32", "String"),
    ("load nowhere as x", "file-not-found", "nowhere", None),
]


@pytest.mark.parametrize("case", MISTAKES, ids=[case[0] for case in MISTAKES])
def test_a_statement_with_a_mistake_has_no_effect(case: tuple[str, str, str, str | None]) -> None:
    line, code, where, remedy = case
    text = TALKER + line + "\n"
    found = run(text)
    (diagnostic,) = found.diagnostics
    assert diagnostic.code == code
    assert marked(text, diagnostic).startswith(where)
    assert remedy is None or remedy in (diagnostic.help or "")
    before = workspace(TALKER)
    after = found.workspace
    assert list(after.nodes) == list(before.nodes)
    assert list(after.messages) == list(before.messages)
    assert after.generations == []
    for kind in ("publishers", "subscriptions", "services", "clients"):
        assert getattr(after.nodes["n"], kind).keys() == getattr(before.nodes["n"], kind).keys()
    assert len(after.nodes["n"].publishers["chatter"].publications) == 1


def test_an_idle_node_is_not_generated() -> None:
    text = NODE + "generate_node n\n"
    found = run(text)
    (diagnostic,) = found.diagnostics
    assert (diagnostic.code, marked(text, diagnostic)) == ("idle-node", "n")
    assert found.workspace.generations == []


LOADED = source(
    endpoint(EndpointKind.PUBLISHER, "out", "std_msgs/String"),
    endpoint(EndpointKind.SUBSCRIPTION, "in", "std_msgs/String", "on_in"),
    endpoint(EndpointKind.SERVICE, "ask", "std_srvs/Trigger", "answer"),
    endpoint(EndpointKind.CLIENT, "call", "std_srvs/SetBool"),
    endpoint(EndpointKind.PUBLISHER, None, "std_msgs/String"),
    endpoint(EndpointKind.SUBSCRIPTION, "untyped"),
)


def test_load() -> None:
    reader = FakeReader({"driver": LOADED})
    node = workspace("load driver as d\n", reader=reader).nodes["d"]
    assert (node.name, node.variable, node.library) == ("driver", "d", "rospy")
    assert node.source is LOADED
    assert list(node.publishers) == ["out"]
    assert node.publishers["out"].publications == ()
    assert {key: each.callback for key, each in node.subscriptions.items()} == {
        "in": "on_in",
        "untyped": None,
    }
    assert node.services["ask"].handler == "answer"
    assert node.clients["call"].requests == ()


def test_load_asks_the_reader_for_what_is_written() -> None:
    reader = FakeReader({"driver": LOADED, "a/b.py": LOADED})
    text = TALKER + "generate_node n\nload driver as d\nload 'a/b.py' as e\n"
    workspace(text, reader=reader)
    assert [(each.source, each.is_path) for each in reader.requests] == [
        ("driver", False),
        ("a/b.py", True),
    ]
    assert [each.node.name for each in reader.requests[0].generated] == ["talker"]


LOAD_CASES = {
    "unsubscribe d from 'in'\nsubscribe d to 'new' of message_type String\n": [],
    "unsubscribe d from 'in'\nsubscribe d to 'in' of message_type Int32\n": [],
    "subscribe d to 'in' of message_type String\n": ["already-subscribed"],
    "subscribe d to 'new' of message_type String calling answer\n": ["function-conflict"],
    "subscribe d to 'untyped' of message_type Int32\n": ["already-subscribed"],
    "d stop_request 'call'\nd stop_service 'ask'\nd stop_publishing to 'out'\n": [],
    "unsubscribe d from 'out'\n": ["not-subscribed"],
    "create_node 'x' as x\nsubscribe x to 'out' of message_type Int32\n": ["topic-type-conflict"],
    "create_node 'x' as x\nx provides_service 'ask' of service_type Trigger\n": [
        "service-provided-twice"
    ],
    "generate_node d\n": [],
}


@pytest.mark.parametrize(("text", "expected"), LOAD_CASES.items(), ids=range(len(LOAD_CASES)))
def test_a_loaded_node_is_a_node(text: str, expected: list[str]) -> None:
    assert codes("load driver as d\n" + text, reader=FakeReader({"driver": LOADED})) == expected


def test_a_loaded_node_that_only_has_a_timer_is_not_idle() -> None:
    timer = source(endpoint(EndpointKind.TIMER, None))
    empty = source(name=None)
    text = "load driver as d\ngenerate_node d\n"
    assert codes(text, reader=FakeReader({"driver": timer})) == []
    assert codes(text, reader=FakeReader({"driver": empty})) == ["idle-node"]
    nodes = workspace("load driver as d\n", reader=FakeReader({"driver": empty})).nodes
    assert nodes["d"].name == "driver"
