"""One program, generated for both generations of ROS: what it does on each is the same."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from graph import Graph, is_rate, rate, rate_of
from machine import mostly_long
from processes import generate, own_tracebacks

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


def numbered(talker: str, count: int, heard: Path) -> str:
    """Return a generated talker whose messages are numbered, until the last says that it is.

    They begin once there is a file, which says that the talker is heard: what is sent before two
    nodes have found each other, in both directions, reaches nobody.
    """
    lines = f"""
import os
import time


def sentences():
    while not os.path.exists({str(heard)!r}):
        yield "is anybody there?"
    for number in range({count}):
        yield f"number {{number}} at {{time.monotonic()}}"
    while True:
        yield "number done"


words = sentences()


class """
    assert talker.count('data="a hundred times a second"') == 1
    return talker.replace("\nclass ", lines, 1).replace('"a hundred times a second"', "next(words)")


def patient(node: str) -> str:
    """Return a generated node whose queue is long: a busy machine holds up what empties it."""
    return re.sub(r"(queue_size=|, )10\)$", r"\g<1>2000)", node, flags=re.MULTILINE)


def twist(*values: float) -> dict[str, dict[str, float]]:
    x, y, z, roll, pitch, yaw = map(float, values)
    return {
        "linear": {"x": x, "y": y, "z": z},
        "angular": {"x": roll, "y": pitch, "z": yaw},
    }


@pytest.mark.long
def test_the_server_answers_every_call_of_the_client(graph: Graph, tmp_path: Path) -> None:
    nodes = generate("services", tmp_path / "output", graph.target)
    answerer = graph.run(nodes["answerer_server.py"])
    asker = graph.run(nodes["asker_client.py"])
    assert asker.wait(120) == 0
    assert asker.output.count("set_bool: ") == 2
    assert asker.output.count("trigger: ") == 1
    assert asker.output.lower().count("success") == 3
    for request in ("True", "False"):
        answerer.wait_to_print(request)
    assert answerer.interrupt() == 0
    assert not own_tracebacks(answerer.output + asker.output)


@pytest.mark.parametrize("graph", mostly_long(["ros1", "ros2"], ["ros2"]), indirect=True)
def test_a_node_does_all_four_things(graph: Graph, tmp_path: Path) -> None:
    nodes = generate("mixture", tmp_path / "output", graph.target)
    mixture = graph.run(nodes["mixture_node.py"])
    helper = graph.run(nodes["helper_node.py"])
    received = graph.listen({"/cmd_vel": "geometry_msgs/Twist"}, 2.5)["/cmd_vel"]
    sent = [each.message for each in received]
    assert twist(0.5, 0, 0, 0, 0, -1.5) in sent
    assert twist(0, 0, 0, 0, 0, 0) in sent
    assert len({str(message) for message in sent}) == 2
    assert is_rate(rate(received), 40)
    assert graph.call("/ready", "std_srvs/Trigger", {}) == {"success": False, "message": ""}
    mixture.wait_to_print("turn left")
    mixture.wait_to_print("set_bool: ")
    helper.wait_to_print("ready: ")
    mixture.wait_to_print("nobody_is_there: ")
    for node in (mixture, helper):
        assert node.interrupt() == 0
        assert not own_tracebacks(node.output)


@pytest.mark.parametrize("graph", mostly_long(["ros1", "ros2"], ["ros2"]), indirect=True)
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


@pytest.mark.long
@pytest.mark.parametrize("count", [100, 1000])
def test_nothing_is_lost_at_a_hundred_hertz(graph: Graph, tmp_path: Path, count: int) -> None:
    program = tmp_path / "fast.plastron"
    program.write_text(FAST)
    nodes = generate(str(program.with_suffix("")), tmp_path / "output", graph.target)
    talker_file = nodes["fast_talker_pub.py"]
    heard = tmp_path / "heard"
    talker_file.write_text(patient(numbered(talker_file.read_text(), count, heard)))
    listener_file = nodes["fast_listener_sub1.py"]
    listener_file.write_text(patient(listener_file.read_text()))
    listener = graph.run(listener_file)
    talker = graph.run(talker_file)
    listener.wait_to_print("is anybody there?")
    heard.touch()
    listener.wait_to_print("number done")
    assert talker.interrupt() == 0
    assert listener.interrupt() == 0
    sent = re.findall(r"number (\d+) at ([\d.]+)", listener.output)
    assert [int(number) for number, _ in sent] == list(range(count))
    assert is_rate(rate_of([float(at) for _, at in sent]), 100)
    assert not own_tracebacks(talker.output + listener.output)
