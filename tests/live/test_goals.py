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
from machine import mostly_long, wait_until
from processes import Process, generate, own_tracebacks
from test_node_interrupts import START, assert_ended, started

pytestmark = pytest.mark.live

TYPE = {"rospy": "actionlib_tutorials/Fibonacci", "rclpy": "example_interfaces/Fibonacci"}
ORDER, ENDLESS = 5, 6
GOAL, FEEDBACK, RESULT = {"order": ORDER}, {"sequence": [3]}, {"sequence": [8]}
UNTIL_ENDED = {
    "rospy": f"range(10 if goal.order == {ORDER} else 10**6)",
    "rclpy": f"range(10 if goal_handle.request.order == {ORDER} else 10**6)",
}
"""Instead of `range(10)`: a goal of another order is worked on until somebody ends it. On a busy
machine five seconds may be over by then."""
REPLACED = {"rospy": "preempted", "rclpy": "aborted"}
"""How a goal ends that a new one replaces: only a client makes a goal of ROS 2 canceled."""
CANCELED = {"rospy": "preempted", "rclpy": "canceled"}
STEP = "# The work of one step goes here."
CHATTER = """\
create_message hello of message_type String and input "hello"
node publish hello to 'chatter' of message_type String at 10 hz
"""
GOALS = "node sends_goal to 'count' of action_type Fibonacci with input order=5\n"
SWITCH = "node client_requests 'enable_motor' of service_type SetBool with input True\n"
READY = "node client_requests 'ready' of service_type Trigger with input none"
PROGRAMS = {
    "calculator": f"{CHATTER}node provides_action 'count' of action_type Fibonacci\n",
    "asker": GOALS,
    "driver": f"{CHATTER}{GOALS}",
    "pilot": f"{SWITCH}{READY}\n",
    "captain": f"{CHATTER}{SWITCH}{READY} at 5 hz\n",
    "follower": f"{CHATTER}node has_parameter 'often' of parameter_type float with default 1.0\n"
    f"{READY} at parameter 'often' hz\n",
    "chooser": "node has_parameter 'order' of parameter_type int with default 1\n"
    "node sends_goal to 'count' of action_type Fibonacci with input order=parameter 'order'\n",
}
"""The nodes that the tests are about; what they ask others, they ask once where no rate is."""


def written(graph: Graph, name: str, folder: Path) -> Path:
    """Generate a node, and return its file."""
    program = f"create_node '{name}' as node\n{PROGRAMS[name]}generate_node node\n"
    folder.mkdir(exist_ok=True)
    source = folder / f"{name}.plastron"
    source.write_text(program)
    [file] = generate(str(source.with_suffix("")), folder / name, graph.target).values()
    return file


def node(graph: Graph, name: str, folder: Path, **changes: str) -> Process:
    """Run a generated node, with the values of some of its constants changed."""
    file = written(graph, name, folder)
    text = file.read_text()
    for constant, value in changes.items():
        text, found = text.replace(f"{constant} = 10.0", f"{constant} = {value}"), text
        assert text != found
    file.write_text(text)
    return graph.run(file)


def changed(graph: Graph, name: str, folder: Path, old: str, new: str) -> Process:
    """Run a generated node in which somebody wrote something."""
    file = written(graph, name, folder)
    text = file.read_text()
    assert text.count(old) == 1
    file.write_text(text.replace(old, new))
    return graph.run(file)


def peer(graph: Graph, command: str, *arguments: object) -> Process:
    script = Path(__file__).with_name(f"peer_{graph.target}.py")
    return graph.run_with(script, command, *map(json.dumps, arguments))


def patient(graph: Graph, folder: Path) -> Process:
    """Run a server that works on a goal of the order ENDLESS until somebody ends it."""
    return changed(graph, "calculator", folder, "range(10)", UNTIL_ENDED[graph.target])


def send(graph: Graph, *, cancel_at: int = 0, second_at: int = 0, order: int = ORDER) -> Process:
    """Send a goal; at a number of feedbacks cancel it, or send a second one."""
    goal = {"order": order}
    return peer(graph, "send", "count", TYPE[graph.target], goal, cancel_at, second_at)


def serve(graph: Graph, how: str) -> Process:
    server = peer(graph, "serve", "count", TYPE[graph.target], how, FEEDBACK, RESULT)
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


def check_goal_of_five_seconds(graph: Graph, server: Process) -> None:
    """A goal is worked on to its end, and what the node sends at 10 hz goes on meanwhile."""
    sender = send(graph)
    assert outcomes(sender) == {0: "succeeded"}, server.output
    # The first one may be sent before the server knows of who listens.
    assert len(told(sender, "feedback", goal=0)) in (9, 10)
    [began], [ended] = times(told(sender, "accepted")), times(told(sender, "result"))
    meanwhile = [each for each in times(told(sender, "message")) if began < each < ended]
    assert len(meanwhile) > 10, server.output
    assert is_rate(rate_of(meanwhile), 10)


@pytest.mark.long
def test_a_goal_of_five_seconds(service_graph: Graph, tmp_path: Path) -> None:
    server = node(service_graph, "calculator", tmp_path)
    check_goal_of_five_seconds(service_graph, server)
    end(server)


@pytest.mark.long
def test_a_goal_is_canceled(service_graph: Graph, tmp_path: Path) -> None:
    server = patient(service_graph, tmp_path)
    sender = send(service_graph, cancel_at=3, order=ENDLESS)
    assert outcomes(sender) == {0: CANCELED[service_graph.target]}, server.output
    assert len(told(sender, "feedback")) >= 3
    # The next goal is worked on as the first one was.
    assert outcomes(send(service_graph)) == {0: "succeeded"}, server.output
    end(server)


@pytest.mark.long
def test_a_new_goal_ends_the_old_one(service_graph: Graph, tmp_path: Path) -> None:
    server = node(service_graph, "calculator", tmp_path)
    sender = send(service_graph, second_at=3)
    assert outcomes(sender) == {0: REPLACED[service_graph.target], 1: "succeeded"}, server.output
    assert 3 <= len(told(sender, "feedback", goal=0)) < 10
    assert len(told(sender, "feedback", goal=1)) == 10
    end(server)


@pytest.mark.long
def test_an_error_aborts_the_goal_alone(service_graph: Graph, tmp_path: Path) -> None:
    server = changed(service_graph, "calculator", tmp_path, STEP, "[].remove('a step')")
    sender = send(service_graph)
    assert outcomes(sender) == {0: "aborted"}, server.output
    assert "not in list" in server.output
    assert outcomes(send(service_graph)) == {0: "aborted"}, server.output
    assert server.interrupt() == 0, server.output


def test_ctrl_c_while_a_goal_is_worked_on(service_graph: Graph, tmp_path: Path) -> None:
    server = patient(service_graph, tmp_path)
    sender = send(service_graph, order=ENDLESS)
    sender.wait_to_print('"feedback"', count=3)
    end(server)
    if service_graph.target == "rospy":
        assert outcomes(sender) == {0: "aborted"}, server.output


@pytest.mark.long
def test_an_error_at_the_start_ends_an_action_server(ros1: Graph, tmp_path: Path) -> None:
    """The thread of actionlib's would keep the process alive."""
    timer = "        rospy.Timer("
    broken = f"        raise RuntimeError('broken')\n{timer}"
    server = changed(ros1, "calculator", tmp_path, timer, broken)
    assert server.wait(60) == 1, server.output
    assert "RuntimeError: broken" in server.output


OUTCOMES = {"succeed": (0, "succeeded"), "abort": (1, "aborted"), "reject": (1, "rejected"),
            "die": (1, "the server is gone")}  # fmt: skip


@pytest.mark.parametrize("how", mostly_long(OUTCOMES, ["succeed"]))
def test_a_client_says_how_its_goal_went(service_graph: Graph, tmp_path: Path, how: str) -> None:
    status, text = OUTCOMES[how]
    server = serve(service_graph, how)
    client = node(service_graph, "asker", tmp_path)
    assert client.wait(120) == status, client.output
    assert not own_tracebacks(client.output), client.output
    assert text in client.output
    assert [each["goal"] for each in told(server, "goal")] == [GOAL]
    # The fields of what the server sends are in the log.
    assert bool(re.search(r"\[3\]|- 3$", client.output, re.M)) == (how != "reject")
    assert bool(re.search(r"\[8\]|- 8$", client.output, re.M)) == (how in ("succeed", "abort"))
    server.interrupt()


@pytest.mark.long
def test_a_client_waits_for_its_server_and_says_so(service_graph: Graph, tmp_path: Path) -> None:
    client = node(service_graph, "driver", tmp_path, WARNING_PERIOD="1.0")
    heard = service_graph.listen({"/chatter": "std_msgs/String"}, 2)["/chatter"]
    assert is_rate(rate_of([each.time for each in heard]), 10)
    client.wait_to_print("count: nobody serves it yet", count=2)
    server = serve(service_graph, "succeed")
    client.wait_to_print("count: succeeded: ")
    assert len(service_graph.listen({"/chatter": "std_msgs/String"}, 1)["/chatter"]) > 1
    assert len(told(server, "goal")) == 1
    end(client)
    server.interrupt()


@pytest.mark.long
@pytest.mark.parametrize("name", ["asker", "driver"])
def test_ctrl_c_while_nobody_serves(service_graph: Graph, tmp_path: Path, name: str) -> None:
    client = node(service_graph, name, tmp_path, WARNING_PERIOD="0.5")
    client.wait_to_print("nobody serves it yet")
    end(client)


@pytest.mark.long
def test_ctrl_c_leaves_the_goal_to_the_server(service_graph: Graph, tmp_path: Path) -> None:
    server = serve(service_graph, "succeed")
    client = node(service_graph, "asker", tmp_path)
    client.wait_to_print("count: ")
    end(client)
    # What the client sent has come by the time that a later goal is reached.
    assert outcomes(send(service_graph)) == {0: "succeeded"}, server.output
    assert not told(server, "cancel")
    server.interrupt()


@pytest.mark.long
def test_a_service_is_called_again(graph: Graph, tmp_path: Path) -> None:
    captain = node(graph, "captain", tmp_path, WARNING_PERIOD="1.0")
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


@pytest.mark.long
def test_requests_do_not_overlap(graph: Graph, tmp_path: Path) -> None:
    server = peer(graph, "answer", 0.7)
    captain = node(graph, "captain", tmp_path)
    wait_until(lambda: len(told(server, "request", service="ready")) > 3, "requests")
    heard = graph.listen({"/chatter": "std_msgs/String"}, 2)["/chatter"]
    assert is_rate(rate_of([each.time for each in heard]), 10)
    end(captain)
    assert {each["flying"] for each in told(server, "request")} == {1}
    server.interrupt()


@pytest.mark.long
def test_a_service_that_does_not_answer_is_asked_again(graph: Graph, tmp_path: Path) -> None:
    server = peer(graph, "answer", 3.0)
    captain = node(graph, "captain", tmp_path, SERVICE_TIMEOUT="0.5")
    captain.wait_to_print("ready: no answer came in time", count=2)
    end(captain)
    server.interrupt()


@pytest.mark.long
def test_a_node_that_ends_says_how_its_calls_went(graph: Graph, tmp_path: Path) -> None:
    alone = node(graph, "pilot", tmp_path / "alone", SERVICE_TIMEOUT="1.0")
    assert alone.wait(60) == 1, alone.output
    assert not own_tracebacks(alone.output)
    server = peer(graph, "answer", 0.0)
    server.wait_to_print('"serving"')
    served = node(graph, "pilot", tmp_path)
    assert served.wait(60) == 0, served.output
    assert [each["service"] for each in told(server, "request")] == ["enable_motor", "ready"]
    server.interrupt()


@pytest.mark.long
def test_requests_follow_the_rate_of_a_parameter(graph: Graph, tmp_path: Path) -> None:
    server = peer(graph, "answer", 0.0)
    follower = node(graph, "follower", tmp_path)
    wait_until(lambda: len(told(server, "request")) > 3, "requests")
    assert is_rate(rate_of(times(told(server, "request"))), 1)
    assert graph.set_parameter("follower", "often", 10.0) is None
    before = len(told(server, "request"))
    wait_until(lambda: len(told(server, "request")) > before + 30, "more requests")
    assert is_rate(rate_of(times(told(server, "request"))[before + 5 :]), 10)
    end(follower)
    server.interrupt()


@pytest.mark.long
def test_a_goal_has_the_parameters_of_when_it_is_sent(service_graph: Graph, tmp_path: Path) -> None:
    chooser = node(service_graph, "chooser", tmp_path, WARNING_PERIOD="0.5")
    chooser.wait_to_print("nobody serves it yet")
    assert service_graph.set_parameter("chooser", "order", 7) is None
    server = serve(service_graph, "succeed")
    chooser.wait_to_print("count: succeeded: ")
    assert [each["goal"] for each in told(server, "goal")] == [{"order": 7}]
    assert chooser.wait(60) == 0, chooser.output
    server.interrupt()


@pytest.mark.long
@pytest.mark.parametrize("name", ["calculator", "driver", "captain"])
def test_ctrl_c_while_a_node_starts(service_graph: Graph, tmp_path: Path, name: str) -> None:
    start = tmp_path / "start.py"
    start.write_text(START)
    file = written(service_graph, name, tmp_path)
    for power in range(6, 13, 2):
        one = started(service_graph, start, file, "*", 2**power)
        assert_ended(service_graph, one, one.wait(60), f"call {2**power}")
        assert "interrupted in" in one.output, one.output
