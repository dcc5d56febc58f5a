"""One program, generated for both generations of ROS: what it does on each is the same."""

from __future__ import annotations

import re
from itertools import pairwise
from pathlib import Path
from statistics import median

import pytest
from graph import Graph, rate
from machine import mostly_long
from processes import generate, own_tracebacks

pytestmark = pytest.mark.live


WARM_UP = 300
"""Messages until the nodes have found each other, at most; those that count follow."""

FAST = """\
create_node 'fast_talker' as talker
create_message words of message_type String and input "a hundred times a second"
talker publish words to 'fast' of message_type String at 100 hz
generate_node talker
create_node 'fast_listener' as listener
subscribe listener to 'fast' of message_type String
generate_node listener
"""


def numbered(talker: str, count: int) -> str:
    """Return a generated talker whose messages are numbered, until the last says that it is."""
    lines = f"""
import itertools
import time

numbers = (f"number {{number}} at {{time.monotonic()}}" for number in range({WARM_UP + count}))
words = itertools.chain(numbers, itertools.repeat("number done"))


class """
    assert talker.count('data="a hundred times a second"') == 1
    return talker.replace("\nclass ", lines, 1).replace('"a hundred times a second"', "next(words)")


def twist(*values: float) -> dict[str, dict[str, float]]:
    x, y, z, roll, pitch, yaw = map(float, values)
    return {
        "linear": {"x": x, "y": y, "z": z},
        "angular": {"x": roll, "y": pitch, "z": yaw},
    }


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


def test_a_node_does_all_four_things(graph: Graph, tmp_path: Path) -> None:
    nodes = generate("mixture", tmp_path / "output", graph.target)
    mixture = graph.run(nodes["mixture_node.py"])
    helper = graph.run(nodes["helper_node.py"])
    received = graph.listen({"/cmd_vel": "geometry_msgs/Twist"}, 2.5)["/cmd_vel"]
    sent = [each.message for each in received]
    assert twist(0.5, 0, 0, 0, 0, -1.5) in sent
    assert twist(0, 0, 0, 0, 0, 0) in sent
    assert len({str(message) for message in sent}) == 2
    assert rate(received) == pytest.approx(40, rel=0.3)
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


@pytest.mark.parametrize("graph", mostly_long(["ros1", "ros2"], ["ros1"]), indirect=True)
@pytest.mark.parametrize("count", [100, pytest.param(1000, marks=pytest.mark.long)])
def test_nothing_is_lost_at_a_hundred_hertz(graph: Graph, tmp_path: Path, count: int) -> None:
    program = tmp_path / "fast.plastron"
    program.write_text(FAST)
    nodes = generate(str(program.with_suffix("")), tmp_path / "output", graph.target)
    talker_file = nodes["fast_talker_pub.py"]
    talker_file.write_text(numbered(talker_file.read_text(), count))
    listener = graph.run(nodes["fast_listener_sub1.py"])
    talker = graph.run(talker_file)
    listener.wait_to_print("number done")
    assert talker.interrupt() == 0
    assert listener.interrupt() == 0
    heard = re.findall(r"number (\d+) at ([\d.]+)", listener.output)
    numbers = [int(number) for number, _ in heard]
    # What was sent before the two had found each other, in both directions, reaches nobody.
    assert numbers[0] < WARM_UP
    counted = [number for number in numbers if number >= WARM_UP]
    assert counted == list(range(WARM_UP, WARM_UP + count))
    pauses = [float(later) - float(earlier) for (_, earlier), (_, later) in pairwise(heard)]
    assert 1 / median(pauses) == pytest.approx(100, rel=0.25)
    assert not own_tracebacks(talker.output + listener.output)
