"""What statements build."""

from __future__ import annotations

import pytest
from workspaces import (
    MESSAGE,
    NODE,
    TALKER,
    codes,
    workspace,
)

from plastron_tui.model.kinds import DEFAULT_RATE, Client, Publisher, Service, Subscription
from plastron_tui.model.values import MessageValue
from plastron_tui.ros.interfaces import InterfaceName

STRING = InterfaceName("std_msgs", "String")


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
    publishers = workspace(text).nodes["n"].of(Publisher)
    assert list(publishers) == ["chatter", "/fast"]
    assert [each.type for each in publishers.values()] == [STRING, STRING]
    rates = [pub.rate for each in publishers.values() for pub in each.publications]
    assert rates == [DEFAULT_RATE, 50.0]
    assert all(isinstance(rate, float) for rate in rates)


def test_a_rate_that_is_not_written_is_open() -> None:
    text = TALKER + "n publish m to 'fast' of message_type String at 10 hz\n"
    publishers = workspace(text).nodes["n"].of(Publisher)
    sent = [publishers[topic].publications[0] for topic in ("chatter", "fast")]
    assert [(each.rate, each.is_rate_open) for each in sent] == [(10.0, True), (10.0, False)]


def test_two_messages_to_one_topic_make_one_publisher() -> None:
    text = (
        TALKER
        + 'create_message m2 of message_type String and input "ho"\n'
        + "n publish m2 to 'chatter' of message_type String at 2 hz\n"
    )
    (publisher,) = workspace(text).nodes["n"].of(Publisher).values()
    sent = [(each.message.variable, each.rate) for each in publisher.publications]
    assert sent == [("m", 10.0), ("m2", 2.0)]


def test_stop_publishing_takes_all_messages_away() -> None:
    text = TALKER + "n stop_publishing to 'chatter'\n"
    node = workspace(text).nodes["n"]
    assert node.of(Publisher) == {}
    assert text.encode()[node.removed["chatter"].start :].startswith(b"n stop_publishing")
    assert codes(text + "generate_node n\n") == ["idle-node"]


def test_subscribe_and_unsubscribe() -> None:
    text = (
        NODE
        + "subscribe n to 'a' of message_type String\n"
        + "subscribe n to 'b' of message_type Int32 calling on_b\n"
    )
    listeners = workspace(text).nodes["n"].of(Subscription)
    assert [(each.name, each.callback) for each in listeners.values()] == [
        ("a", None),
        ("b", "on_b"),
    ]
    left = workspace(text + "unsubscribe n from 'a'\n").nodes["n"].of(Subscription)
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
    assert [(each.name, each.callback) for each in node.of(Service).values()] == [
        ("s", None),
        ("t", "do_t"),
    ]
    add = node.of(Client)["add"]
    assert add.type == InterfaceName("beginner_tutorials", "AddTwoInts")
    assert [request.value.fields for request in add.requests] == [{"a": 5, "b": 6}, {"b": 1}]
    assert [request.value.fields for request in node.of(Client)["w"].requests] == [{}]
    left = workspace(text + "n stop_service 's'\nn stop_request 'add'\n").nodes["n"]
    assert (list(left.of(Service)), list(left.of(Client))) == (["t"], ["w"])


def test_endpoints_keep_the_order_of_the_program() -> None:
    names = ["z", "a", "m", "b"]
    text = NODE + "".join(f"subscribe n to '{name}' of message_type String\n" for name in names)
    assert list(workspace(text).nodes["n"].of(Subscription)) == names
    again = text + "unsubscribe n from 'a'\nsubscribe n to 'a' of message_type String\n"
    assert list(workspace(again).nodes["n"].of(Subscription)) == ["z", "m", "b", "a"]


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
    assert (list(first.node.of(Publisher)), list(first.node.of(Subscription))) == (["chatter"], [])
    assert (list(second.node.of(Publisher)), list(second.node.of(Subscription))) == ([], ["a"])


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
    packages = [nodes[key].of(Service)["add"].type for key in "ab"]
    assert [type_ and type_.package for type_ in packages] == [
        "beginner_tutorials",
        "example_interfaces",
    ]
