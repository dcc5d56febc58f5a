"""The studio's monitors, beside real nodes of both generations."""

from __future__ import annotations

import math
import subprocess
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from graph import Graph
from machine import wait_until
from processes import generate_one
from test_goals import CANCELED, ENDLESS, ORDER, TYPE, patient

import plastron_tui.runtime.observers as observers
from plastron_tui.runtime.live_graph import LiveGraph, LiveSending
from plastron_tui.runtime.monitor import Monitor, MonitorCommand

pytestmark = [pytest.mark.live, pytest.mark.long]

PROGRAM = """\
create_node 'robot' as robot
create_message go of message_type Twist and input linear.x=0.5
robot publish go to 'cmd_vel' of message_type Twist at 10 hz
subscribe robot to 'goal' of message_type Float64
robot provides_service 'switch' of service_type SetBool
robot has_parameter 'speed' of parameter_type float with default 0.5
generate_node robot
"""

COUNTED = """
import time, rclpy
rclpy.init()
node = rclpy.create_node("counts")
end = time.monotonic() + 30
while time.monotonic() < end and not node.count_publishers("/cmd_vel"):
    time.sleep(0.1)
while time.monotonic() < end and node.count_publishers("/goal"):
    time.sleep(0.1)
print(node.count_publishers("/cmd_vel"), node.count_publishers("/goal"))
"""


class Watched:
    """A monitor, and what it has said."""

    def __init__(self, graph: Graph) -> None:
        self.version = 1 if graph.target == "rospy" else 2
        script = Path(observers.__file__).with_name(f"monitor_ros{self.version}.py")
        command = MonitorCommand(self.version, (str(graph.python), str(script)), dict(graph.env))
        self.monitor = Monitor(command, lambda: None)
        self.known = LiveGraph(self.version)
        self.answers: dict[int, dict[str, Any]] = {}

    def until(self, condition: Any, what: str) -> None:
        """Wait for something that the monitor says."""
        wait_until(lambda: self._is(condition), what, 60)

    def _is(self, condition: Any) -> bool:
        for report in self.monitor.take():
            if report.get("tell") == "answer":
                self.answers[report["id"]] = dict(report)
            self.known.feed(report)
        assert self.monitor.ended is None, self.monitor.ended
        return bool(condition())

    def ask(self, number: int, **order: Any) -> dict[str, Any]:
        """Let the monitor do something, and return what came of it."""
        assert self.monitor.order(id=number, **order)
        self.until(lambda: number in self.answers, f"an answer to {order}")
        return self.answers[number]


@pytest.fixture
def watched(graph: Graph) -> Iterator[Watched]:
    watched = Watched(graph)
    yield watched
    watched.monitor.close()
    wait_until(lambda: watched.monitor.ended is not None, "the monitor ends", 60)


def test_what_runs_is_seen_and_spoken_to(graph: Graph, tmp_path: Path, watched: Watched) -> None:
    (program := tmp_path / "robot.plastron").write_text(PROGRAM)
    node = graph.run_and_wait(generate_one(str(program.with_suffix("")), tmp_path, graph.target))
    topics, known = watched.known.topics, watched.known
    watched.until(lambda: known.nodes.get("/robot") and len(known.topics) == 2, "the graph")
    topics = known.topics
    assert (topics["/cmd_vel"].publishers, topics["/goal"].subscribers) == (1, 1)
    assert topics["/cmd_vel"].type == "geometry_msgs/Twist"
    qos = "" if graph.target == "rospy" else "reliable"

    def ends(name: str) -> bool:
        return known.topics[name].ends == (("/robot", name == "/cmd_vel", qos),)

    watched.until(lambda: ends("/cmd_vel") and ends("/goal"), "who is there")
    watched.until(lambda: list(known.services) == ["/switch"], "the service")
    # Nobody looks, and nothing is listened to.
    assert topics["/cmd_vel"].count == 0
    watched.monitor.order(
        do="watch", topics=["/cmd_vel", "/goal"], full=["/cmd_vel"], nodes=["/robot"]
    )
    watched.until(lambda: known.topics["/cmd_vel"].rate > 2, "a rate")
    topic = known.topics["/cmd_vel"]
    assert topic.text == "linear.x: 0.5" and 0.5 in topic.samples
    assert topic.fields[0] == ("linear.x", "0.5")
    watched.until(lambda: known.parameters.get("/robot"), "the parameters")
    (speed,) = known.parameters["/robot"]
    assert (speed.name, speed.value, speed.type) == ("speed", 0.5, "float")
    # It is seen to listen as well, but not as one of theirs.
    assert topic.subscribers == 0
    said = watched.ask(1, do="publish", name="/goal", type="std_msgs/Float64", values={"data": 2.5})
    assert (said["text"], said["is_failure"]) == ("sent to /goal", False)
    node.wait_to_print("2.5")
    watched.until(lambda: known.topics["/goal"].text == "2.5", "what was sent")
    # JSON has it as `-Infinity`.
    watched.ask(6, do="publish", name="/goal", type="std_msgs/Float64", values={"data": -math.inf})
    node.wait_to_print("-inf")
    said = watched.ask(2, do="call", name="/switch", type="std_srvs/SetBool", values={"data": True})
    assert "success: " in said["text"] and not said["is_failure"]
    said = watched.ask(3, do="set", node="/robot", name="speed", value=0.75, type="float")
    assert said["text"].startswith("speed is 0.75 now") and not said["is_failure"], said
    watched.until(lambda: known.parameters["/robot"][0].value == 0.75, "the new value")
    # A node that starts later does not get what was sent before it came.
    if graph.target == "rclpy":
        command = [str(graph.python), "-c", COUNTED]
        found = subprocess.run(command, env=dict(graph.env), capture_output=True, timeout=60)
        assert found.stdout.split() == [b"1", b"0"], found
    # What cannot be is said.
    said = watched.ask(4, do="publish", name="/goal", type="no_such/Type", values={})
    assert said["is_failure"]
    said = watched.ask(5, do="publish", name="/goal", type="std_msgs/Float64", values={"x": 1})
    assert said["is_failure"]
    node.interrupt()
    watched.until(lambda: known.nodes["/robot"] is False, "the node is gone")
    assert known.topics["/goal"].is_gone or known.topics["/goal"].subscribers == 0


def test_goals_are_sent_and_canceled(
    service_graph: Graph, tmp_path: Path, request: pytest.FixtureRequest
) -> None:
    server = patient(service_graph, tmp_path)
    watched: Watched = Watched(service_graph)
    request.addfinalizer(watched.monitor.close)
    known, type_ = watched.known, TYPE[service_graph.target]
    watched.until(lambda: known.actions and known.actions["/count"].servers == 1, "the action")
    assert known.actions["/count"].type == type_
    assert len(known.actions["/count"].nodes) == 1
    # Its topics are not there once more.
    assert not [name for name in known.topics if "/count" in name]

    def send(number: int, order: int) -> None:
        values = {"order": order}
        assert watched.monitor.order(do="goal", id=number, name="/count", type=type_, values=values)

    send(1, ENDLESS)
    watched.until(lambda: 1 in known.goals and "sequence" in known.goals[1].text, "feedback")
    goal = known.goals[1]
    assert (goal.action, goal.sent, goal.state) == ("/count", f"order: {ENDLESS}", "accepted")
    assert not goal.is_over
    watched.monitor.order(do="cancel", goal=1)
    watched.until(lambda: known.goals[1].is_over, "its end")
    assert known.goals[1].state == CANCELED[service_graph.target]
    # The monitor's own client is none of theirs.
    assert known.actions["/count"].servers == 1
    send(2, ORDER)
    watched.until(lambda: 2 in known.goals and known.goals[2].is_over, "the result")
    assert known.goals[2].state == "succeeded" and not known.goals[2].is_failure
    # Nobody works on it any more once the server is gone.
    send(3, ENDLESS)
    watched.until(lambda: 3 in known.goals and "sequence" in known.goals[3].text, "feedback")
    server.kill()
    watched.until(lambda: known.goals[3].is_over and known.goals[3].is_failure, "the loss")
    said = watched.ask(4, do="goal", name="/count", type="no_such/Type", values={})
    assert said["is_failure"]


def test_a_message_is_sent_at_a_rate_until_it_is_stopped(
    graph: Graph, tmp_path: Path, watched: Watched
) -> None:
    (program := tmp_path / "robot.plastron").write_text(PROGRAM)
    node = graph.run_and_wait(generate_one(str(program.with_suffix("")), tmp_path, graph.target))
    known = watched.known
    watched.until(lambda: "/goal" in known.topics, "the topic")
    order: dict[str, Any] = {"name": "/goal", "type": "std_msgs/Float64", "rate": 20}
    watched.ask(1, do="publish", values={"data": 1.5}, **order)
    node.wait_to_print("1.5", count=3)
    assert known.sendings["/goal"] == LiveSending(20, "1.5")
    # Another one replaces it, and what was sent is not one of theirs.
    watched.ask(2, do="publish", values={"data": 2.5}, **order)
    node.wait_to_print("2.5", count=3)
    assert known.topics["/goal"].publishers == 0
    watched.monitor.order(do="stop", name="/goal")
    watched.until(lambda: not known.sendings, "the end")
    # What is sent now is the next that comes.
    before = node.output.count("2.5")
    watched.ask(3, do="publish", name="/goal", type="std_msgs/Float64", values={"data": 3.5})
    node.wait_to_print("3.5")
    assert node.output.count("2.5") <= before + 1
    # It ends with whoever holds the monitor's pipe.
    watched.ask(4, do="publish", values={"data": 4.5}, **order)
    node.wait_to_print("4.5", count=3)
    watched.monitor.close()
    wait_until(lambda: watched.monitor.ended is not None, "the monitor ends", 60)
    before = node.output.count("4.5")
    time.sleep(1)
    assert node.output.count("4.5") <= before + 1
