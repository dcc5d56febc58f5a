"""What nodes share: the types of their topics and services, in each of the two graphs."""

from __future__ import annotations

import pytest
from workspaces import (
    NODE,
    FakeReader,
    codes,
    marked,
    run,
    source,
    workspace,
)

from plastron_tui.diagnostics import Severity
from plastron_tui.model.kinds import Publisher, Service
from plastron_tui.model.values import MessageValue
from plastron_tui.ros.interfaces import InterfaceName


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
    stamps = [nodes[key].of(Publisher)["t"].publications[0].message.value for key in "ab"]
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
    assert codes(text.replace(" using rclpy", "")) == ["unknown-type"] * 2


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
    ("~/x", "/first/x"): True,
    ("~/x", "first/x"): True,
    ("~/x", "~/x"): False,
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
    assert list(found.workspace.nodes["b"].of(Service)) == ["/s"]
    assert codes(text.replace("b provides", "n stop_service 's'\nb provides")) == []


def test_a_service_of_a_node_that_is_loaded_again_is_no_warning() -> None:
    reader = FakeReader({"driver": source(name="driver")})
    text = (
        "load driver as a\na provides_service 's' of service_type Trigger\ngenerate_node a\n"
        "load driver as b\nb provides_service 's' of service_type Trigger\ngenerate_node b\n"
    )
    assert codes(text, reader=reader) == []
