"""The files that `plastron generate` writes, on a real ROS 1 master."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from statistics import mean

import pytest
from graph import Graph, Received
from processes import generate

pytestmark = pytest.mark.live

REPORT_TOPICS = {
    "/chatter": ("geometry_msgs/Point", {"x": 5.0, "y": 6.0, "z": 7.0}),
    "/chatter1": ("geometry_msgs/Vector3", {"x": 1.0, "y": 3.0, "z": 0.0}),
    "/chatter2": ("std_msgs/String", {"data": "hello_World"}),
    "/chatter3": ("geometry_msgs/Quaternion", {"x": 8.0, "y": 9.0, "z": 10.0, "w": 11.0}),
    "/chatter4": ("geometry_msgs/Pose2D", {"x": 1.0, "y": 2.0, "theta": 80.0}),
}


def rate(received: list[Received]) -> float:
    """Return how often messages came, in hertz."""
    return 1 / mean(later.time - earlier.time for earlier, later in pairwise(received))


def test_the_publisher_sends_its_five_messages_at_ten_hertz(ros1: Graph, tmp_path: Path) -> None:
    nodes = generate("publisher", tmp_path / "output", ros1.target)
    node = ros1.run(nodes["publisher_pub.py"])
    received = ros1.listen({topic: type_ for topic, (type_, _) in REPORT_TOPICS.items()}, 4)
    for topic, (_, fields) in REPORT_TOPICS.items():
        assert [each.message for each in received[topic]] == [fields] * len(received[topic]), topic
        assert rate(received[topic]) == pytest.approx(10, rel=0.1), topic
    assert node.interrupt() == 0
    assert "Traceback" not in node.output


def test_the_server_answers_the_three_calls_of_the_client(ros1: Graph, tmp_path: Path) -> None:
    generate("server", tmp_path / "output", ros1.target)
    nodes = generate("client", tmp_path / "output", ros1.target)
    server = ros1.run(nodes["server_server.py"])
    client = ros1.run(nodes["client_client.py"])
    assert client.wait(30) == 0
    answers = (
        "/add_two_ints: sum: 0",
        "/waypoint_clear: success: False",
        "/set_bool: success: False",
    )
    for answer in answers:
        assert answer in client.output
    assert "a: 5" in server.output
    assert "b: 6" in server.output
    assert "data: True" in server.output
    assert server.interrupt() == 0
    assert "Traceback" not in server.output + client.output
