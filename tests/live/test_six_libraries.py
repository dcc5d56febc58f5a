"""One program for six client libraries does the same with each.

What it does is seen by scripts that know nothing of Plastron: by the graph, by who plays to its
topics and services, and by who sends it goals and serves its own.

A nodelet is loaded into a manager, a component into a container. With the stand-in of rclcpp, which
has no container, a component's class is made a program of; it has no actions either, and who takes
goals there is not among the tests.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any
from xmlrpc.client import ServerProxy

import pytest
from cpp_builds import CppLibrary, describe_rclcpp, find_rclcpp, real_prefix
from cpp_corpus import Built, build_with_catkin, build_with_colcon, program_with
from cpp_nodes import CppGraph
from cpp_plugins import component_program, load_component, load_nodelet
from graph import Graph, is_rate, rate
from machine import wait_until
from played_nodes import HEADER, scan, vector
from processes import Process, generate, own_tracebacks
from test_goals import CANCELED, outcomes, send, serve, told
from traffic import Step, call, plain, wait
from traffic import send as send_message

pytestmark = [pytest.mark.live, pytest.mark.long]

PYTHON = ("rospy", "rclpy")
ROS_1 = ("rospy", "roscpp", "nodelet")
LIBRARIES = (*ROS_1, "rclpy", "rclcpp", "component")

TYPES = {
    "publishers": {
        "/gear": "std_msgs/Int32",
        "/mood": "std_msgs/String",
        "/greeting": "std_msgs/String",
        "/halt": "geometry_msgs/Twist",
        "/cmd_vel": "geometry_msgs/Twist",
    },
    "subscriptions": {
        "/scan": "sensor_msgs/LaserScan",
        "/joy": "sensor_msgs/Joy",
        "/words": "std_msgs/String",
    },
    "services": {"/guard": "std_srvs/SetBool"},
}
"""What the graph says of the node, but for what every node of its library has."""

SERVES = {"/ready": ("std_srvs/Trigger", {"success": True, "message": "at ease"})}


def joy(*axes: float) -> dict[str, Any]:
    return {"header": HEADER, "axes": axes}


STEPS: list[Step] = [
    wait("/greeting", {"data": "here I am"}),
    send_message("/scan", scan(1.0, 0.25), "/halt"),
    send_message("/scan", scan(1.0, 2.0)),
    send_message("/joy", joy(0.5, 1.0), "/cmd_vel"),
    send_message("/joy", joy(0.5)),
    send_message("/scan", scan(0.25), "/halt"),
    call("/guard", {"data": True}),
    call("/guard", {"data": False}),
    # What is sent at a rate, and what is asked at one.
    send_message("/words", {"data": "who goes there"}, "/ready", "/ready", "/gear", "/mood"),
]


def twist(x: float, z: float) -> dict[str, Any]:
    return {"linear": vector(x), "angular": vector(0.0, 0.0, z)}


@dataclass
class Seen:
    """What was seen of a node; of what comes at a rate, which messages there are."""

    endpoints: Mapping[str, Mapping[str, str]]
    caused: Mapping[str, list[Any]]
    periodic: Mapping[str, list[Any]]
    answers: list[Any]
    rates: Mapping[str, bool]
    changed: Mapping[str, Any]
    after_what_is_refused: Mapping[str, Any]
    followed: bool
    ended: int


EXPECTED = Seen(
    endpoints=TYPES,
    caused={
        "/halt": [twist(0.0, 0.0)] * 2,
        "/cmd_vel": [twist(0.5, 0.5)],
        "/greeting": [{"data": "here I am"}],
    },
    periodic={"/gear": [{"data": 1}], "/mood": [{"data": "calm"}], "/ready": [{}]},
    answers=[
        {"success": True, "message": "on guard"},
        {"success": False, "message": "on guard"},
    ],
    rates={"/gear": True, "/mood": True},
    changed={"/gear": 4, "/mood": "alert"},
    after_what_is_refused={"/gear": 4, "/mood": "alert"},
    followed=True,
    ended=0,
)


@dataclass
class Nodes:
    """The nodes of a client library in a graph.

    Attributes:
        graph: where they run.
        start: starts one by its name, and waits until it has topics and services if they are named.
    """

    graph: Graph
    start: Callable[..., Process]


def python_nodes(graph: Graph, folder: Path) -> Nodes:
    def start(name: str, wanted: tuple[str, ...] = ()) -> Process:
        program = str(program_with(name).with_suffix(""))
        made = generate(program, folder / name, graph.target)
        [file] = [made[each] for each in made if each.startswith(f"{name}_")]
        return graph.run_and_wait(file) if wanted else graph.run(file)

    return Nodes(graph, start)


def cpp_nodes(
    ros: Graph, library: str, built: Built, folder: Path, rclcpp: CppLibrary | None
) -> Nodes:
    # A line of rosconsole that is not written at once would be waited for.
    line_by_line = {"ROSCONSOLE_STDOUT_LINE_BUFFERED": "1"}
    environ = line_by_line if rclcpp is None else rclcpp.environ
    parts = (ros.python, ros.probe, ros.env, ros.folder, ros.started)
    graph = CppGraph(ros.target, *parts, program_env=environ)

    def start(name: str, wanted: tuple[str, ...] = ()) -> Process:
        waiting = replace(graph, wanted=wanted)
        if library == "nodelet":
            process = load_nodelet(waiting, built, name)
        elif library == "component" and rclcpp is not None and rclcpp.is_real:
            process = load_component(waiting, built, name)
        elif library == "component":
            assert rclcpp is not None
            process = waiting.run(component_program(name, folder, rclcpp))
        else:
            process = waiting.run(built.program(name))
        if wanted:
            # What nodelets have is that of the node whose process they are in.
            told_of = f"{name}_manager" if library == "nodelet" else name
            process.told = waiting.described(told_of)
        return process

    return Nodes(graph, start)


@pytest.fixture(scope="session")
def rclcpp(tmp_path_factory: pytest.TempPathFactory) -> CppLibrary:
    return find_rclcpp(tmp_path_factory)


@pytest.fixture
def nodes(request: pytest.FixtureRequest, tmp_path: Path, shared_cache: Path) -> Nodes:
    """The program's nodes, for the client library that is the parameter."""
    name = request.param
    graph: Graph = request.getfixturevalue("ros1" if name in ROS_1 else "ros2_with_services")
    if name in ROS_1:
        # One master serves all tests, and keeps what the last node was told.
        master = ServerProxy(graph.env["ROS_MASTER_URI"])
        if master.hasParam("/test", "/sentry")[2]:
            master.deleteParam("/test", "/sentry")
    if name in PYTHON:
        return python_nodes(graph, tmp_path)
    if name in ROS_1:
        return cpp_nodes(graph, name, build_with_catkin(shared_cache), tmp_path, None)
    library: CppLibrary = request.getfixturevalue("rclcpp")
    built = build_with_colcon(shared_cache, library, graph.env)
    return cpp_nodes(graph, name, built, tmp_path, built.library)


def named(libraries: tuple[str, ...]) -> list[Any]:
    """Return parameters whose names say what a node of ROS 2 is compiled with."""
    real = {name: f"{name} ({describe_rclcpp()})" for name in ("rclcpp", "component")}
    return [pytest.param(name, id=real.get(name, name)) for name in libraries]


def seen(nodes: Nodes) -> tuple[Seen, str]:
    """Run the node, play to it, change its parameters, end it; return its output as well."""
    graph = nodes.graph
    wanted = tuple(name for each in TYPES.values() for name in each)
    process = nodes.start("sentry", wanted)
    [described] = re.findall("^endpoints: (.*)$", process.output, re.MULTILINE)
    endpoints = json.loads(described)
    play = json.dumps([endpoints, SERVES, [asdict(step) for step in STEPS]])
    player = graph.run_with(Path(__file__).with_name("player.py"), play)
    assert player.wait(120) == 0, player.output + process.output
    played = json.loads(player.output.splitlines()[-1])
    heard = plain(played["heard"])

    periodic = {topic: TYPES["publishers"][topic] for topic in ("/gear", "/mood")}
    came = graph.listen(periodic, 3)
    rates = {"/gear": is_rate(rate(came["/gear"]), 10), "/mood": is_rate(rate(came["/mood"]), 20)}

    def values(seconds: float) -> dict[str, Any]:
        last = graph.listen(periodic, seconds)
        return {topic: each[-1].message["data"] for topic, each in last.items()}

    for name, value in {"gear": 4, "mood": "alert"}.items():
        assert graph.set_parameter("sentry", name, value) is None
    wait_until(lambda: values(0.1) == EXPECTED.changed, "the new values", 60)
    # ROS 1 has nobody to refuse it: there it is not used.
    refused = graph.set_parameter("sentry", "gear", 9)
    assert graph.target == "rospy" or refused
    after = values(0.5)
    assert graph.set_parameter("sentry", "rate", 50.0) is None
    gear = {"/gear": periodic["/gear"]}
    wait_until(lambda: is_rate(rate(graph.listen(gear, 2)["/gear"]), 50), "the new rate", 60)
    process.wait_to_print("look_around", count=2)
    found = Seen(
        endpoints={
            kind: {name: each["type"] for name, each in endpoints[kind].items()} for kind in TYPES
        },
        caused={topic: heard[topic] for topic in EXPECTED.caused},
        periodic={topic: _distinct(heard[topic]) for topic in EXPECTED.periodic},
        answers=played["answers"],
        rates=rates,
        changed=dict(EXPECTED.changed),
        after_what_is_refused=after,
        followed=True,
        ended=process.interrupt(20),
    )
    return found, process.output


def _distinct(messages: list[Any]) -> list[Any]:
    return [each for place, each in enumerate(messages) if each not in messages[:place]]


@pytest.mark.parametrize("nodes", named(LIBRARIES), indirect=True)
def test_the_same_traffic(nodes: Nodes) -> None:
    found, output = seen(nodes)
    assert found == EXPECTED
    for words in ("who goes there", "at ease"):
        assert words in output
    assert not own_tracebacks(output)


# The stand-in of rclcpp has no actions.
WITH_ACTIONS = tuple(
    name for name in LIBRARIES if real_prefix() is not None or name not in ("rclcpp", "component")
)


@pytest.mark.parametrize("nodes", named(WITH_ACTIONS), indirect=True)
def test_the_same_goals(nodes: Nodes) -> None:
    graph = nodes.graph
    counter = nodes.start("counter")
    assert outcomes(send(graph)) == {0: "succeeded"}
    assert outcomes(send(graph, cancel_at=2)) == {0: CANCELED[graph.target]}
    assert counter.interrupt(20) == 0, counter.output
    server = serve(graph, "succeed")
    asker = nodes.start("asker")
    asker.wait_to_print("succeeded")
    assert [each["goal"] for each in told(server, "goal")] == [{"order": 5}]
