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


def twist(*values: float) -> dict[str, dict[str, float]]:
    x, y, z, roll, pitch, yaw = map(float, values)
    return {
        "linear": {"x": x, "y": y, "z": z},
        "angular": {"x": roll, "y": pitch, "z": yaw},
    }


def test_the_publisher_sends_its_five_messages_at_ten_hertz(ros1: Graph, tmp_path: Path) -> None:
    nodes = generate("publisher", tmp_path / "output", ros1.target)
    node = ros1.run(nodes["publisher_pub.py"])
    received = ros1.listen({topic: type_ for topic, (type_, _) in REPORT_TOPICS.items()}, 4)
    for topic, (_, fields) in REPORT_TOPICS.items():
        assert [each.message for each in received[topic]] == [fields] * len(received[topic]), topic
        assert rate(received[topic]) == pytest.approx(10, rel=0.1), topic
    node.interrupt()
    assert "Traceback" not in node.output


def test_the_subscriber_logs_what_another_node_sends(ros1: Graph, tmp_path: Path) -> None:
    generate("subscriber", tmp_path / "output", ros1.target)
    nodes = generate("talker", tmp_path / "output", ros1.target)
    subscriber = ros1.run(nodes["subscriber_sub1.py"])
    ros1.run(nodes["talker_pub.py"])
    subscriber.wait_to_print("hello, turtle")
    assert "chatter" in subscriber.output
    subscriber.interrupt()
    assert "Traceback" not in subscriber.output


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
    server.interrupt()
    assert "Traceback" not in server.output + client.output


def test_a_loaded_node_listens_to_the_new_topic_only(ros1: Graph, tmp_path: Path) -> None:
    output = tmp_path / "output"
    generate("subscriber", output, ros1.target)
    nodes = generate("load", output, ros1.target)
    assert list(nodes) == ["subscriber_sub1.py"]
    ros1.run(nodes["subscriber_sub1.py"])
    found = ros1.wait_for_endpoint("subscriber", "subscriptions", "/topic_added_after_load")
    assert found["subscriptions"] == ["/topic_added_after_load"]


def test_a_node_does_all_four_things(ros1: Graph, tmp_path: Path) -> None:
    nodes = generate("mixture", tmp_path / "output", ros1.target)
    mixture = ros1.run(nodes["mixture_node.py"])
    helper = ros1.run(nodes["helper_node.py"])
    received = ros1.listen({"/cmd_vel": "geometry_msgs/Twist"}, 2)["/cmd_vel"]
    sent = [each.message for each in received]
    assert sorted({message["linear"]["x"] for message in sent}) == [0.0, 0.5]
    assert twist(0.5, 0, 0, 0, 0, -1.5) in sent
    assert twist(0, 0, 0, 0, 0, 0) in sent
    assert rate(received) == pytest.approx(40, rel=0.1)
    assert ros1.call("/ready", "std_srvs/Trigger", {}) == {"success": False, "message": ""}
    mixture.wait_to_print("turn left")
    mixture.wait_to_print("/set_bool: success: False")
    helper.wait_to_print("/ready: success: False")
    mixture.wait_to_print("timeout exceeded while waiting for service /nobody_is_there")
    for node in (mixture, helper):
        node.interrupt()
        assert "Traceback" not in node.output


def test_a_twist_is_the_same_however_it_is_written(ros1: Graph, tmp_path: Path) -> None:
    nodes = generate("twists", tmp_path / "output", ros1.target)
    ros1.run(nodes["twists_pub.py"])
    expected = {
        "/nested": twist(1, 2, 3, 4, 5, 6),
        "/named": twist(1.5, 0, 0, 0, 0, -0.5),
        "/flattened": twist(1, 0, 0, 0, 0, 0.5),
    }
    received = ros1.listen(dict.fromkeys(expected, "geometry_msgs/Twist"), 1)
    for topic, fields in expected.items():
        assert received[topic]
        assert {str(each.message) for each in received[topic]} == {str(fields)}
