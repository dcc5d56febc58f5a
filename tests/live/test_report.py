"""The report's five programs, on a real graph of each generation."""

from __future__ import annotations

from pathlib import Path

import pytest
from graph import Graph, is_rate, rate
from machine import mostly_long
from processes import generate, own_tracebacks

pytestmark = pytest.mark.live

TOPICS = {
    "/chatter": ("geometry_msgs/Point", {"x": 5.0, "y": 6.0, "z": 7.0}),
    "/chatter1": ("geometry_msgs/Vector3", {"x": 1.0, "y": 3.0, "z": 0.0}),
    "/chatter2": ("std_msgs/String", {"data": "hello_World"}),
    "/chatter3": ("geometry_msgs/Quaternion", {"x": 8.0, "y": 9.0, "z": 10.0, "w": 11.0}),
    "/chatter4": ("geometry_msgs/Pose2D", {"x": 1.0, "y": 2.0, "theta": 80.0}),
}


@pytest.mark.long
def test_the_publisher_sends_its_five_messages_at_ten_hertz(graph: Graph, tmp_path: Path) -> None:
    nodes = generate("publisher", tmp_path / "output", graph.target)
    node = graph.run(nodes["publisher_pub.py"])
    received = graph.listen({topic: type_ for topic, (type_, _) in TOPICS.items()}, 3.5)
    for topic, (_, fields) in TOPICS.items():
        assert [each.message for each in received[topic]] == [fields] * len(received[topic]), topic
        assert is_rate(rate(received[topic]), 10), topic
    assert node.interrupt() == 0
    assert not own_tracebacks(node.output)


@pytest.mark.parametrize("graph", mostly_long(["ros1", "ros2"], ["ros1"]), indirect=True)
def test_the_subscriber_logs_what_another_node_sends(graph: Graph, tmp_path: Path) -> None:
    generate("subscriber", tmp_path / "output", graph.target)
    nodes = generate("talker", tmp_path / "output", graph.target)
    subscriber = graph.run(nodes["subscriber_sub1.py"])
    graph.run(nodes["talker_pub.py"])
    subscriber.wait_to_print("hello, turtle")
    assert subscriber.interrupt() == 0
    assert not own_tracebacks(subscriber.output)


def test_the_server_answers_the_three_calls_of_the_client(
    service_graph: Graph, tmp_path: Path
) -> None:
    generate("server", tmp_path / "output", service_graph.target)
    nodes = generate("client", tmp_path / "output", service_graph.target)
    server = service_graph.run(nodes["server_server.py"])
    client = service_graph.run(nodes["client_client.py"])
    assert client.wait(120) == 0
    # rospy writes `sum: 0`, rclpy `AddTwoInts_Response(sum=0)`.
    told = client.output.replace("=", ": ")
    for service, answer in {
        "add_two_ints": "sum: 0",
        "waypoint_clear": "success: False",
        "set_bool": "success: False",
    }.items():
        [line] = [line for line in told.splitlines() if f"{service}: " in line]
        assert answer in line
    heard = server.output.replace("=", ": ")
    for request in ("a: 5", "b: 6", "data: True"):
        assert request in heard
    assert server.interrupt() == 0
    assert not own_tracebacks(server.output + client.output)


@pytest.mark.long
def test_a_loaded_node_listens_to_the_new_topic_only(graph: Graph, tmp_path: Path) -> None:
    output = tmp_path / "output"
    generate("subscriber", output, graph.target)
    nodes = generate("load", output, graph.target)
    assert list(nodes) == ["subscriber_sub1.py"]
    graph.run_and_wait(nodes["subscriber_sub1.py"])
    found = graph.wait_for_endpoint("subscriber", "subscriptions", "/topic_added_after_load")
    assert found["subscriptions"] == ["/topic_added_after_load"]
