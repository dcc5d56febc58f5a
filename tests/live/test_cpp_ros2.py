"""Nodes of ROS 2 in C++ do what those in Python do, seen by who knows nothing of Plastron.

They are compiled with the rclcpp of the environment, or else with the stand-in, which has no
actions and no managed nodes.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import pytest
from cpp_builds import CppLibrary, find_rclcpp
from cpp_nodes import CppGraph
from graph import Graph
from machine import wait_until
from processes import PROGRAMS, Process
from roscpp_builds import generate_cpp, locked
from test_goals import FEEDBACK, RESULT, TYPE, outcomes, peer, send, told
from test_parameters import BAD, GOOD, TYPES, values
from test_reactions import STEPS, assert_reflexes
from traffic import record

pytestmark = [pytest.mark.live, pytest.mark.long]

CHATTER = """\
create_message hello of message_type String and input "hello"
node publish hello to 'chatter' of message_type String at 10 hz
node client_requests 'ready' of service_type Trigger with input none at 5 hz
"""
MORE = """\
node publish hello to 'first' of message_type String once
subscribe node to 'a' of message_type String calling hear
subscribe node to 'b' of message_type Int32 calling hear
create_message one of message_type Int32 and input 1
node publish one to 'late' of message_type Int32 once with qos latched
node publish one to 'fast' of message_type Int32 at 20 hz with qos sensor_data
node publish one to 'pulse' of message_type Int32 at 20 hz with qos deadline 0.5, manual_by_topic, lease 1
node client_requests 'enable_motor' of service_type SetBool with input True
"""  # noqa: E501
PILOT = """\
node client_requests 'enable_motor' of service_type SetBool with input True
node client_requests 'ready' of service_type Trigger with input none
"""
COUNTING = """\
node provides_action 'count' of action_type Fibonacci
node sends_goal to 'other' of action_type Fibonacci with input order=5
"""


def _program(name: str, statements: str, *, managed: str = "") -> str:
    file = PROGRAMS / f"{name}.plastron"
    lines = file.read_text().splitlines()[1:-1] if file.exists() else []
    own = "\n".join(re.sub(rf"^(subscribe )?{name} ", r"\1node ", line) for line in lines)
    head = f"create_node '{name}' as node {managed}"
    return f"{head}\n{own}\n{statements}generate_node node using rclcpp\n"


NODES = {
    "reflex": _program("reflex", CHATTER + MORE),
    "cruiser": _program("cruiser", CHATTER),
    "pilot": _program("pilot", PILOT),
}
WITH_ACTIONS = {
    "counter": _program("counter", CHATTER + COUNTING),
    "keeper": _program("keeper", CHATTER + COUNTING, managed="managed"),
}

# What rclcpp itself says of a managed node that Ctrl-C ends.
EXPECTED = "LifecycleNode is not shut down"
COMPLAINT = re.compile(rf"\[(?:WARN|ERROR|FATAL)\](?!.*{EXPECTED})|terminate called")


@pytest.fixture(scope="session")
def rclcpp(tmp_path_factory: pytest.TempPathFactory) -> CppLibrary:
    return find_rclcpp(tmp_path_factory)


def compiled(rclcpp: CppLibrary, cache: Path, programs: Mapping[str, str]) -> dict[str, Path]:
    """Generate and compile nodes, once for all workers."""
    made: dict[str, Path] = {}
    for name, program in programs.items():
        folder = cache / "rclcpp_nodes" / name
        made[name] = folder / name
        with locked(folder):
            if not made[name].exists():
                # One has its class in a header.
                layout = "split" if name == "cruiser" else "single"
                file = generate_cpp(program, folder / "files", layout)
                # Who waits for an answer is not to keep the tests waiting.
                file.write_text(file.read_text().replace("TIMEOUT{10}", "TIMEOUT{2}"))
                headers = [file.parents[1] / "include"] if layout == "split" else []
                rclcpp.compile(made[name], file, headers=headers)
    return made


@pytest.fixture(scope="session")
def programs(rclcpp: CppLibrary, shared_cache: Path) -> dict[str, Path]:
    return compiled(rclcpp, shared_cache, NODES)


@pytest.fixture(scope="session")
def with_actions(
    rclcpp: CppLibrary, shared_cache: Path, ros2_services_env: dict[str, str]
) -> CppLibrary:
    return rclcpp.with_types(ros2_services_env, shared_cache)


@pytest.fixture(scope="session")
def actors(with_actions: CppLibrary, shared_cache: Path) -> dict[str, Path]:
    # `conftest.py` leaves these tests out where there is the stand-in alone, which has no actions.
    return compiled(with_actions, shared_cache, WITH_ACTIONS)


def in_cpp(ros: Graph, rclcpp: CppLibrary) -> CppGraph:
    parts = (ros.python, ros.probe, ros.env, ros.folder, ros.started)
    return CppGraph("rclpy", *parts, program_env=rclcpp.environ)


@pytest.fixture
def cpp(ros2: Graph, rclcpp: CppLibrary) -> CppGraph:
    """A graph of ROS 2 whose nodes are in C++."""
    return in_cpp(ros2, rclcpp)


def end(*nodes: Process) -> None:
    """Ctrl-C ends each node, with status 0, and nobody complains of it."""
    for each in nodes:
        before = len(COMPLAINT.findall(each.output))
        assert each.interrupt(20) == 0, each.output
        assert len(COMPLAINT.findall(each.output)) == before, each.output


def test_what_follows_from_a_message(cpp: CppGraph, programs: dict[str, Path]) -> None:
    causes = {name for step in STEPS for name in (step.name, *step.causes)}
    traffic = record(replace(cpp, wanted=causes), programs["reflex"], STEPS, {})
    assert_reflexes(traffic)


def test_a_node_and_its_peers(cpp: CppGraph, programs: dict[str, Path]) -> None:
    """It publishes as it is to, and calls services, and all that goes on at once."""
    node = replace(cpp, wanted=["/chatter", "/a", "/b"]).run_and_wait(programs["reflex"])
    node.wait_to_print("first: nobody listens yet")
    asked = peer(cpp, "answer", 0.1)
    node.wait_to_print("ready: {success", count=3)
    node.wait_to_print("enable_motor: {success")
    assert {each["flying"] for each in told(asked, "request", service="ready")} == {1}
    assert told(asked, "request", service="enable_motor", request={"data": True})
    heard = cpp.listen({"/first": "std_msgs/String"}, 0.5)
    assert [each.message for each in heard["/first"]] == [{"data": "hello"}]
    for topic, words in {
        "/late": ["transient_local"],
        "/fast": ["best_effort"],
        "/pulse": ["deadline", "manual_by_topic"],
    }.items():
        assert cpp.listen({topic: "std_msgs/Int32"}, 0.2, words)[topic]
    end(node)


def test_parameters(cpp: CppGraph, programs: dict[str, Path]) -> None:
    node = replace(cpp, wanted=TYPES).run_and_wait(programs["cruiser"])
    for name, value in GOOD.items():
        assert cpp.set_parameter("cruiser", name, value) is None
    wait_until(lambda: values(cpp.listen(TYPES, 0.1)) == GOOD, "the new values", 60)
    for name, bad in BAD.items():
        for value in bad:
            assert cpp.set_parameter("cruiser", name, value), (name, value)
    assert values(cpp.listen(TYPES, 0.5)) == GOOD
    assert cpp.set_parameter("cruiser", "rate", float("nan")) == "rate is not a number"
    assert cpp.set_parameter("cruiser", "rate", 50.0) is None
    assert len(cpp.listen({"/cmd_vel": TYPES["/cmd_vel"]}, 1.0)["/cmd_vel"]) > 20
    assert cpp.set_parameter("cruiser", "ports", [2**31]) is None
    node.wait_to_print("ports, of parameter 'ports': ")
    end(node)


def test_a_parameter_that_begins_as_no_number(cpp: CppGraph, programs: dict[str, Path]) -> None:
    given = ("--ros-args", "-p", "speed:=.nan")
    node = cpp.run_program(programs["cruiser"], *given, environ=cpp.program_env)
    assert node.wait(60) != 0, node.output
    assert "speed is not a number" in node.output


def test_a_node_that_ends_after_its_calls(cpp: CppGraph, programs: dict[str, Path]) -> None:
    pilot = programs["pilot"]
    alone = cpp.run(pilot)
    alone.wait_to_print("enable_motor: the service is not there")
    assert alone.wait(30) == 1, alone.output
    assert "ready: the service is not there" in alone.output
    waiting = cpp.run(pilot)
    waiting.wait_to_print("enable_motor: the service is not there")
    end(waiting)
    mute = peer(cpp, "answer", 600)
    mute.wait_to_print('"serving"')
    failing = cpp.run(pilot)
    failing.wait_to_print("enable_motor: no answer came in time")
    assert failing.wait(30) == 1, failing.output
    mute.kill()
    peer(cpp, "answer", 0).wait_to_print('"serving"')
    served = cpp.run(pilot)
    assert served.wait(60) == 0, served.output
    assert "ready: {success" in served.output


def test_goals(
    actors: dict[str, Path], ros2_with_services: Graph, with_actions: CppLibrary
) -> None:
    graph = in_cpp(ros2_with_services, with_actions)
    node = replace(graph, wanted=["/chatter"]).run_and_wait(actors["counter"])
    served = peer(graph, "serve", "other", TYPE["rclpy"], "succeed", FEEDBACK, RESULT)
    node.wait_to_print("other: succeeded: {sequence: [8]}")
    assert "other: {sequence: [3]}" in node.output
    assert told(served, "goal") == told(served, "goal", goal={"order": 5})
    assert outcomes(send(graph)) == {0: "succeeded"}
    assert outcomes(send(graph, cancel_at=2)) == {0: "canceled"}
    assert outcomes(send(graph, second_at=2)) == {0: "aborted", 1: "succeeded"}
    sender = send(graph)
    wait_until(lambda: told(sender, "feedback"), "a feedback")
    end(node)


def test_a_simulation_paces_a_node(
    actors: dict[str, Path], ros2_with_services: Graph, with_actions: CppLibrary
) -> None:
    graph, chatter = ros2_with_services, {"/chatter": "std_msgs/String"}
    given = ("--ros-args", "-p", "use_sim_time:=true")
    node = graph.run_program(actors["counter"], *given, environ=with_actions.environ)
    graph.wait_for_endpoint("counter", "publishers", "/chatter")
    assert graph.listen(chatter, 0.5, silent=list(chatter))["/chatter"] == []
    graph.run_with(Path(__file__).with_name("simulated_clock.py"))
    assert graph.listen(chatter, 0.2)["/chatter"]
    end(node)


def test_a_managed_node(
    actors: dict[str, Path], ros2_with_services: Graph, with_actions: CppLibrary
) -> None:
    graph = in_cpp(ros2_with_services, with_actions)
    node = graph.run(actors["keeper"])

    def go(*labels: str) -> None:
        for label, success, *_ in graph.lifecycle("keeper", [(each, None) for each in labels]):
            assert success, (label, node.output)

    assert graph.endpoints("keeper")["publishers"] == [
        "/keeper/transition_event",
        "/parameter_events",
        "/rosout",
    ]
    served = peer(graph, "serve", "other", TYPE["rclpy"], "wait", FEEDBACK, RESULT)
    go("configure")
    assert outcomes(send(graph)) == {0: "rejected"}
    go("activate")
    wait_until(lambda: told(served, "goal"), "a goal")
    assert graph.listen({"/chatter": "std_msgs/String"}, 0.2)["/chatter"]
    sender = send(graph)
    wait_until(lambda: told(sender, "feedback"), "a feedback")
    go("deactivate")
    assert outcomes(sender) == {0: "aborted"}
    go("cleanup", "configure", "activate")
    assert outcomes(send(graph)) == {0: "succeeded"}
    end(node)
