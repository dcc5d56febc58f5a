"""One program, generated for both generations of ROS: what it does on each is the same."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from statistics import mean

import pytest
from graph import Graph, Received
from processes import PROGRAMS, generate

pytestmark = pytest.mark.live


FAST = """\
create_node 'fast_talker' as talker
create_message words of message_type String and input "a hundred times a second"
talker publish words to 'fast' of message_type String at 100 hz
generate_node talker
create_node 'fast_listener' as listener
subscribe listener to 'fast' of message_type String
generate_node listener
"""


def rate(received: list[Received]) -> float:
    """Return how often messages came, in hertz."""
    return 1 / mean(later.time - earlier.time for earlier, later in pairwise(received))


def twist(*values: float) -> dict[str, dict[str, float]]:
    x, y, z, roll, pitch, yaw = map(float, values)
    return {
        "linear": {"x": x, "y": y, "z": z},
        "angular": {"x": roll, "y": pitch, "z": yaw},
    }


def test_the_publisher_sends_its_messages_at_ten_hertz(graph: Graph, tmp_path: Path) -> None:
    # ROS 2 has no Pose2D since Kilted: the report's program without its fifth message.
    lines = (PROGRAMS / "publisher.plastron").read_text().splitlines(keepends=True)
    program = tmp_path / "publisher.plastron"
    program.write_text("".join(line for line in lines if "Pose2D" not in line))
    expected = {
        "/chatter": ("geometry_msgs/Point", {"x": 5.0, "y": 6.0, "z": 7.0}),
        "/chatter1": ("geometry_msgs/Vector3", {"x": 1.0, "y": 3.0, "z": 0.0}),
        "/chatter2": ("std_msgs/String", {"data": "hello_World"}),
        "/chatter3": ("geometry_msgs/Quaternion", {"x": 8.0, "y": 9.0, "z": 10.0, "w": 11.0}),
    }
    nodes = generate(str(program.with_suffix("")), tmp_path / "output", graph.target)
    node = graph.run(nodes["publisher_pub.py"])
    received = graph.listen({topic: type_ for topic, (type_, _) in expected.items()}, 3)
    for topic, (_, fields) in expected.items():
        assert [each.message for each in received[topic]] == [fields] * len(received[topic])
        assert rate(received[topic]) == pytest.approx(10, rel=0.1), topic
    assert node.interrupt() == 0
    assert "Traceback" not in node.output


def test_the_subscriber_logs_what_another_node_sends(graph: Graph, tmp_path: Path) -> None:
    generate("subscriber", tmp_path / "output", graph.target)
    nodes = generate("talker", tmp_path / "output", graph.target)
    subscriber = graph.run(nodes["subscriber_sub1.py"])
    graph.run(nodes["talker_pub.py"])
    subscriber.wait_to_print("hello, turtle")
    assert subscriber.interrupt() == 0
    assert "Traceback" not in subscriber.output


def test_the_server_answers_every_call_of_the_client(graph: Graph, tmp_path: Path) -> None:
    nodes = generate("services", tmp_path / "output", graph.target)
    answerer = graph.run(nodes["answerer_server.py"])
    asker = graph.run(nodes["asker_client.py"])
    assert asker.wait(40) == 0
    assert asker.output.count("set_bool: ") == 2
    assert asker.output.count("trigger: ") == 1
    assert asker.output.lower().count("success") == 3
    for request in ("True", "False"):
        answerer.wait_to_print(request)
    assert answerer.interrupt() == 0
    assert "Traceback" not in answerer.output + asker.output


def test_a_loaded_node_listens_to_the_new_topic_only(graph: Graph, tmp_path: Path) -> None:
    output = tmp_path / "output"
    generate("subscriber", output, graph.target)
    nodes = generate("load", output, graph.target)
    assert list(nodes) == ["subscriber_sub1.py"]
    graph.run(nodes["subscriber_sub1.py"])
    found = graph.wait_for_endpoint("subscriber", "subscriptions", "/topic_added_after_load")
    assert found["subscriptions"] == ["/topic_added_after_load"]


def test_a_node_does_all_four_things(graph: Graph, tmp_path: Path) -> None:
    nodes = generate("mixture", tmp_path / "output", graph.target)
    mixture = graph.run(nodes["mixture_node.py"])
    helper = graph.run(nodes["helper_node.py"])
    received = graph.listen({"/cmd_vel": "geometry_msgs/Twist"}, 2)["/cmd_vel"]
    sent = [each.message for each in received]
    assert twist(0.5, 0, 0, 0, 0, -1.5) in sent
    assert twist(0, 0, 0, 0, 0, 0) in sent
    assert len({str(message) for message in sent}) == 2
    assert rate(received) == pytest.approx(40, rel=0.1)
    assert graph.call("/ready", "std_srvs/Trigger", {}) == {"success": False, "message": ""}
    mixture.wait_to_print("turn left")
    mixture.wait_to_print("set_bool: ")
    helper.wait_to_print("ready: ")
    mixture.wait_to_print("nobody_is_there: ")
    for node in (mixture, helper):
        assert node.interrupt() == 0
        assert "Traceback" not in node.output


def test_a_twist_is_the_same_however_it_is_written(graph: Graph, tmp_path: Path) -> None:
    nodes = generate("twists", tmp_path / "output", graph.target)
    graph.run(nodes["twists_pub.py"])
    expected = {
        "/nested": twist(1, 2, 3, 4, 5, 6),
        "/named": twist(1.5, 0, 0, 0, 0, -0.5),
        "/flattened": twist(1, 0, 0, 0, 0, 0.5),
    }
    received = graph.listen(dict.fromkeys(expected, "geometry_msgs/Twist"), 1)
    for topic, fields in expected.items():
        assert {str(each.message) for each in received[topic]} == {str(fields)}


def test_nothing_is_lost_at_a_hundred_hertz(graph: Graph, tmp_path: Path) -> None:
    program = tmp_path / "fast.plastron"
    program.write_text(FAST)
    nodes = generate(str(program.with_suffix("")), tmp_path / "output", graph.target)
    listener = graph.run(nodes["fast_listener_sub1.py"])
    talker = graph.run(nodes["fast_talker_pub.py"])
    received = graph.listen({"/fast": "std_msgs/String"}, 10)["/fast"]
    assert talker.interrupt() == 0
    heard = listener.output.count("a hundred times a second")
    assert rate(received) == pytest.approx(100, rel=0.1)
    assert max(later.time - earlier.time for earlier, later in pairwise(received)) < 0.5
    assert heard >= len(received) > 900
    assert "Traceback" not in talker.output + listener.output
