"""Nodes that serve service_graph, send goals and call services again, on a real ROS.

What they talk to (`peer_rospy.py`, `peer_rclpy.py`) knows nothing of Plastron.
"""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest
from graph import Graph, is_rate, rate_of
from machine import wait_until
from processes import Process, own_tracebacks
from test_node_interrupts import START, assert_ended, started

pytestmark = pytest.mark.live

NODES = Path(__file__).parents[1] / "nodes"
ACTIONS: dict[str, tuple[str, dict[str, Any], dict[str, Any], dict[str, Any]]] = {
    "rospy": ("actionlib/Test", {"goal": 5}, {"feedback": 3}, {"result": 8}),
    "rclpy": ("example_interfaces/Fibonacci", {"order": 5}, {"sequence": [3]}, {"sequence": [8]}),
}
"""Of each library an action type, and the fields of a goal, a feedback and a result."""
REPLACED = {"rospy": "preempted", "rclpy": "aborted"}
"""How a goal ends that a new one replaces: only a client makes a goal of ROS 2 canceled."""
CANCELED = {"rospy": "preempted", "rclpy": "canceled"}
STEP = "# The work of one step goes here."


def node(graph: Graph, name: str, folder: Path, **changes: str) -> Process:
    """Run a node of the collection, with the values of some of its constants changed."""
    text = (NODES / graph.target / f"{name}.py").read_text()
    for constant, value in changes.items():
        text, found = text.replace(f"{constant} = 10.0", f"{constant} = {value}"), text
        assert text != found
    file = folder / f"{name}.py"
    file.write_text(text)
    return graph.run(file)


def changed(graph: Graph, name: str, folder: Path, old: str, new: str) -> Process:
    """Run a node of the collection in which somebody wrote something."""
    text = (NODES / graph.target / f"{name}.py").read_text()
    assert text.count(old) == 1
    file = folder / f"{name}.py"
    file.write_text(text.replace(old, new))
    return graph.run(file)


def peer(graph: Graph, command: str, *arguments: object) -> Process:
    script = Path(__file__).with_name(f"peer_{graph.target}.py")
    return graph.run_with(script, command, *map(json.dumps, arguments))


def send(graph: Graph, cancel_at: int = 0, second_at: int = 0) -> Process:
    """Send a goal; at a number of feedbacks cancel it, or send a second one."""
    type_, goal, _, _ = ACTIONS[graph.target]
    return peer(graph, "send", "count", type_, goal, cancel_at, second_at)


def serve(graph: Graph, how: str) -> Process:
    type_, _, feedback, result = ACTIONS[graph.target]
    server = peer(graph, "serve", "count", type_, how, feedback, result)
    server.wait_to_print('"serving"')
    return server


def told(process: Process, event: str, **fields: object) -> list[dict[str, Any]]:
    """Return what a peer told of one kind of event."""
    lines = [line for line in process.output.splitlines() if line.startswith('{"event"')]
    return [
        each
        for each in map(json.loads, lines)
        if each["event"] == event and fields.items() <= each.items()
    ]


def outcomes(sender: Process) -> dict[int, str]:
    assert sender.wait(180) == 0, sender.output
    return {each["goal"]: each["status"] for each in told(sender, "result")}


def end(*nodes: Process) -> None:
    """Ctrl-C ends each node, with status 0 and without a traceback."""
    for each in nodes:
        assert each.interrupt() == 0, each.output
        assert not own_tracebacks(each.output), each.output


def times(events: Sequence[dict[str, Any]]) -> list[float]:
    return [each["time"] for each in events]


def test_a_goal_of_five_seconds(service_graph: Graph, tmp_path: Path) -> None:
    server = node(service_graph, "action_server", tmp_path)
    sender = send(service_graph)
    assert outcomes(sender) == {0: "succeeded"}, server.output
    # The first one may be sent before the server knows of who listens.
    assert len(told(sender, "feedback", goal=0)) in (9, 10)
    [began], [ended] = times(told(sender, "accepted")), times(told(sender, "result"))
    meanwhile = [each for each in times(told(sender, "message")) if began < each < ended]
    assert len(meanwhile) > 10, server.output
    assert is_rate(rate_of(meanwhile), 10)
    end(server)


def test_a_goal_is_canceled(service_graph: Graph, tmp_path: Path) -> None:
    server = node(service_graph, "action_server", tmp_path)
    sender = send(service_graph, cancel_at=3)
    assert outcomes(sender) == {0: CANCELED[service_graph.target]}, server.output
    assert 3 <= len(told(sender, "feedback")) < 10
    # The next goal is worked on as the first one was.
    assert outcomes(send(service_graph)) == {0: "succeeded"}, server.output
    end(server)


def test_a_new_goal_ends_the_old_one(service_graph: Graph, tmp_path: Path) -> None:
    server = node(service_graph, "action_server", tmp_path)
    sender = send(service_graph, second_at=3)
    assert outcomes(sender) == {0: REPLACED[service_graph.target], 1: "succeeded"}, server.output
    assert 3 <= len(told(sender, "feedback", goal=0)) < 10
    assert len(told(sender, "feedback", goal=1)) == 10
    end(server)


def test_an_error_aborts_the_goal_alone(service_graph: Graph, tmp_path: Path) -> None:
    server = changed(service_graph, "action_server", tmp_path, STEP, "[].remove('a step')")
    sender = send(service_graph)
    assert outcomes(sender) == {0: "aborted"}, server.output
    assert "not in list" in server.output
    assert outcomes(send(service_graph)) == {0: "aborted"}, server.output
    assert server.interrupt() == 0, server.output


def test_ctrl_c_while_a_goal_is_worked_on(service_graph: Graph, tmp_path: Path) -> None:
    server = node(service_graph, "action_server", tmp_path)
    sender = send(service_graph)
    sender.wait_to_print('"feedback"', count=3)
    end(server)
    if service_graph.target == "rospy":
        assert outcomes(sender) == {0: "aborted"}, server.output


def test_an_error_at_the_start_ends_an_action_server(ros1: Graph, tmp_path: Path) -> None:
    """The thread of actionlib's would keep the process alive."""
    timer = "        rospy.Timer("
    broken = f"        raise RuntimeError('broken')\n{timer}"
    server = changed(ros1, "action_server", tmp_path, timer, broken)
    assert server.wait(60) == 1, server.output
    assert "RuntimeError: broken" in server.output


OUTCOMES = {"succeed": (0, "succeeded"), "abort": (1, "aborted"), "reject": (1, "rejected"),
            "die": (1, "the server is gone")}  # fmt: skip


@pytest.mark.parametrize("how", OUTCOMES)
def test_a_client_says_how_its_goal_went(service_graph: Graph, tmp_path: Path, how: str) -> None:
    status, text = OUTCOMES[how]
    server = serve(service_graph, how)
    client = node(service_graph, "action_client", tmp_path)
    assert client.wait(120) == status, client.output
    assert not own_tracebacks(client.output), client.output
    assert text in client.output
    assert [each["goal"] for each in told(server, "goal")] == [ACTIONS[service_graph.target][1]]
    # The fields of what the server sends are in the log.
    assert bool(re.search(r"feedback: 3|\[3\]", client.output)) == (how != "reject")
    assert bool(re.search(r"result: 8|\[8\]", client.output)) == (how in ("succeed", "abort"))
    server.interrupt()


def test_a_client_waits_for_its_server_and_says_so(service_graph: Graph, tmp_path: Path) -> None:
    client = node(service_graph, "action_client_busy", tmp_path, WARNING_PERIOD="1.0")
    heard = service_graph.listen({"/chatter": "std_msgs/String"}, 2)["/chatter"]
    assert is_rate(rate_of([each.time for each in heard]), 10)
    client.wait_to_print("count: nobody serves it yet", count=2)
    server = serve(service_graph, "succeed")
    client.wait_to_print("count: succeeded: ")
    assert len(service_graph.listen({"/chatter": "std_msgs/String"}, 1)["/chatter"]) > 1
    assert len(told(server, "goal")) == 1
    end(client)
    server.interrupt()


@pytest.mark.parametrize("name", ["action_client", "action_client_busy"])
def test_ctrl_c_while_nobody_serves(service_graph: Graph, tmp_path: Path, name: str) -> None:
    client = node(service_graph, name, tmp_path, WARNING_PERIOD="0.5")
    client.wait_to_print("nobody serves it yet")
    end(client)


def test_ctrl_c_leaves_the_goal_to_the_server(service_graph: Graph, tmp_path: Path) -> None:
    server = serve(service_graph, "succeed")
    client = node(service_graph, "action_client", tmp_path)
    client.wait_to_print("count: ")
    end(client)
    # What the client sent has come by the time that a later goal is reached.
    assert outcomes(send(service_graph)) == {0: "succeeded"}, server.output
    assert not told(server, "cancel")
    server.interrupt()


def test_a_service_is_called_again(graph: Graph, tmp_path: Path) -> None:
    captain = node(graph, "service_client_busy", tmp_path, WARNING_PERIOD="1.0")
    captain.wait_to_print("ready: nobody serves it yet")
    captain.wait_to_print("enable_motor: nobody serves it yet", count=2)
    server = peer(graph, "answer", 0.0)
    captain.wait_to_print("enable_motor: ", count=3)
    wait_until(lambda: len(told(server, "request", service="ready")) > 20, "many requests")
    assert is_rate(rate_of(times(told(server, "request", service="ready"))), 5)
    heard = graph.listen({"/chatter": "std_msgs/String"}, 2)["/chatter"]
    assert is_rate(rate_of([each.time for each in heard]), 10)
    # It goes on when the server comes back, and what is asked once is asked once.
    assert len(told(server, "request", service="enable_motor")) == 1
    server.interrupt()
    captain.wait_to_print("ready: nobody serves it yet", count=captain.output.count("yet") + 1)
    back = peer(graph, "answer", 0.0)
    wait_until(lambda: len(told(back, "request", service="ready")) > 3, "requests")
    assert not told(back, "request", service="enable_motor")
    end(captain)
    back.interrupt()


def test_requests_do_not_overlap(graph: Graph, tmp_path: Path) -> None:
    server = peer(graph, "answer", 0.7)
    captain = node(graph, "service_client_busy", tmp_path)
    wait_until(lambda: len(told(server, "request", service="ready")) > 3, "requests")
    heard = graph.listen({"/chatter": "std_msgs/String"}, 2)["/chatter"]
    assert is_rate(rate_of([each.time for each in heard]), 10)
    end(captain)
    assert {each["flying"] for each in told(server, "request")} == {1}
    server.interrupt()


def test_a_service_that_does_not_answer_is_asked_again(graph: Graph, tmp_path: Path) -> None:
    server = peer(graph, "answer", 3.0)
    captain = node(graph, "service_client_busy", tmp_path, SERVICE_TIMEOUT="0.5")
    captain.wait_to_print("ready: no answer came in time", count=2)
    end(captain)
    server.interrupt()


def test_a_node_that_ends_says_how_its_calls_went(graph: Graph, tmp_path: Path) -> None:
    alone = node(graph, "service_client", tmp_path, SERVICE_TIMEOUT="1.0")
    assert alone.wait(60) == 1, alone.output
    assert not own_tracebacks(alone.output)
    server = peer(graph, "answer", 0.0)
    server.wait_to_print('"serving"')
    served = node(graph, "service_client", tmp_path)
    assert served.wait(60) == 0, served.output
    assert [each["service"] for each in told(server, "request")] == ["enable_motor", "ready"]
    server.interrupt()


@pytest.mark.long
@pytest.mark.parametrize("name", ["action_server", "action_client_busy", "service_client_busy"])
def test_ctrl_c_while_a_node_starts(service_graph: Graph, tmp_path: Path, name: str) -> None:
    start = tmp_path / "start.py"
    start.write_text(START)
    file = NODES / service_graph.target / f"{name}.py"
    for power in range(6, 13):
        one = started(service_graph, start, file, "*", 2**power)
        assert_ended(service_graph, one, one.wait(60), f"call {2**power}")
        assert "interrupted in" in one.output, one.output
