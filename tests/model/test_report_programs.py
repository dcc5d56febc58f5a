"""The five test programs of the report that the language comes from mean what it says."""

from __future__ import annotations

from pathlib import Path

import pytest
from workspaces import FakeReader, codes, endpoint, run, source, workspace

from plastron_tui.model.kinds import DEFAULT_RATE, Client, Publisher, Service, Subscription
from plastron_tui.model.source import EndpointKind

PROGRAMS = Path(__file__).parents[1] / "programs"


def program(name: str) -> str:
    return (PROGRAMS / f"{name}.plastron").read_text(encoding="utf-8")


def test_the_publisher_sends_five_messages_to_five_topics() -> None:
    found = workspace(program("publisher"))
    (generation,) = found.generations
    node = generation.node
    assert (node.name, generation.library) == ("publisher", "rospy")
    sent = {
        topic: (str(publisher.type), publisher.publications[0].message.value.fields)
        for topic, publisher in node.of(Publisher).items()
    }
    assert sent == {
        "chatter": ("geometry_msgs/Point", {"x": 5.0, "y": 6.0, "z": 7.0}),
        "chatter1": ("geometry_msgs/Vector3", {"x": 1.0, "y": 3.0, "z": 0.0}),
        "chatter2": ("std_msgs/String", {"data": "hello_World"}),
        "chatter3": ("geometry_msgs/Quaternion", {"x": 8.0, "y": 9.0, "z": 10.0, "w": 11.0}),
        "chatter4": ("geometry_msgs/Pose2D", {"x": 1.0, "y": 2.0, "theta": 80.0}),
    }
    rates = {pub.rate for each in node.of(Publisher).values() for pub in each.publications}
    assert rates == {DEFAULT_RATE}
    assert not (node.of(Subscription) or node.of(Service) or node.of(Client))


def test_the_subscriber_listens_to_one_topic() -> None:
    (generation,) = workspace(program("subscriber")).generations
    (listener,) = generation.node.of(Subscription).values()
    assert (generation.node.name, listener.name, str(listener.type)) == (
        "subscriber",
        "chatter",
        "std_msgs/String",
    )


def test_the_client_makes_three_calls() -> None:
    (generation,) = workspace(program("client")).generations
    calls = {
        name: (str(client.type), [request.value.fields for request in client.requests])
        for name, client in generation.node.of(Client).items()
    }
    assert calls == {
        "add_two_ints": ("beginner_tutorials/AddTwoInts", [{"a": 5, "b": 6}]),
        "waypoint_clear": ("mavros_msgs/WaypointClear", [{}]),
        "set_bool": ("std_srvs/SetBool", [{"data": True}]),
    }


def test_the_server_provides_three_services() -> None:
    (generation,) = workspace(program("server")).generations
    services = {name: str(each.type) for name, each in generation.node.of(Service).items()}
    assert services == {
        "add_two_ints": "beginner_tutorials/AddTwoInts",
        "waypoint_clear": "mavros_msgs/WaypointClear",
        "set_bool": "std_srvs/SetBool",
    }


def test_the_loaded_node_changes_its_topic() -> None:
    chatter = endpoint(EndpointKind.SUBSCRIPTION, "chatter", "std_msgs/String", "on_chatter")
    reader = FakeReader({"subscriber_sub1": source(chatter, name="subscriber")})
    (generation,) = workspace(program("load"), reader=reader).generations
    assert generation.node.name == "subscriber"
    assert list(generation.node.of(Subscription)) == ["topic_added_after_load"]
    assert generation.node.source is reader.files["subscriber_sub1"]


@pytest.mark.parametrize("name", ["publisher", "client", "server", "subscriber"])
def test_the_same_programs_in_ros_2(name: str) -> None:
    (generation,) = workspace(program(name), "rclpy").generations
    assert generation.library == "rclpy"


def test_the_slip_of_the_tutorial() -> None:
    text = (
        program("client")
        .replace("node3", "node1")
        .replace("generate_node node1", "generate_node node3")
    )
    (found,) = run(text).diagnostics
    assert (found.code, found.help) == ("unknown-node", "did you mean `node1`?")
    assert codes(text) == ["unknown-node"]
