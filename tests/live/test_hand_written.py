"""Nodes that a person wrote, changed by programs, run, and asked of a real ROS 1 master."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

import pytest
from graph import Graph
from machine import mostly_long
from processes import edit, own_tracebacks

pytestmark = pytest.mark.live

NODES = Path(__file__).parents[1] / "nodes" / "live"


@dataclass(frozen=True)
class Case:
    """A node, what a program changes, and what the master must then say.

    `there` and `gone` are endpoints by kind; `heard` are messages that come over a topic, and
    `answers` what a service says.
    """

    file: str
    node: str
    program: str
    there: Mapping[str, tuple[str, ...]]
    gone: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    heard: Mapping[str, tuple[str, object]] = field(default_factory=dict)
    answers: Mapping[str, tuple[str, Mapping[str, object], Mapping[str, object]]] = field(
        default_factory=dict
    )
    prints: tuple[str, ...] = ()


CASES = [
    Case(
        "heater.py",
        "heater",
        "node stop_publishing to 'state'\n"
        "create_message m of message_type String and input \"warm\"\n"
        "node publish m to 'mood' of message_type String\n"
        "node provides_service 'off' of service_type Trigger\n",
        there={"publishers": ("/temperature", "/mood"), "subscriptions": ("/wanted",),
               "services": ("/off",)},
        gone={"publishers": ("/state",)},
        heard={"/mood": ("std_msgs/String", {"data": "warm"})},
        answers={"/off": ("std_srvs/Trigger", {}, {"success": False, "message": ""})},
    ),
    Case(
        "lamp.py",
        "lamp",
        "node stop_service 'lamp/switch'\n"
        "node provides_service 'lamp/toggle' of service_type SetBool calling _switch\n"
        "subscribe node to 'dim' of message_type Float32\n",
        there={"publishers": ("/lamp/state",), "subscriptions": ("/dim",),
               "services": ("/lamp/toggle",)},
        gone={"services": ("/lamp/switch",)},
        heard={"/lamp/state": ("std_msgs/Bool", {"data": False})},
        answers={"/lamp/toggle": (
            "std_srvs/SetBool", {"data": True}, {"success": True, "message": "switched"})},
    ),
    Case(
        "counter.py",
        "counter",
        "unsubscribe node from 'tick'\n"
        "subscribe node to 'other_tick' of message_type std_msgs/Empty calling on_tick\n"
        "node stop_service 'reset'\n"
        "create_message m of message_type Int32 and input 7\n"
        "node publish m to 'seven' of message_type Int32 at 20 hz\n",
        there={"publishers": ("/total", "/seven"), "subscriptions": ("/other_tick",)},
        gone={"subscriptions": ("/tick",), "services": ("/reset",)},
        heard={"/seven": ("std_msgs/Int32", {"data": 7})},
    ),
    Case(
        "pilot",
        "pilot",
        "node stop_publishing to 'alarm'\n"
        "subscribe node to 'lamp/state' of message_type Bool calling on_lamp\n"
        "create_message m of message_type Vector3 and input 1,2,3\n"
        "node publish m to 'gravity' of message_type Vector3\n",
        there={"publishers": ("/cmd_vel", "/gravity"), "subscriptions": ("/stop", "/lamp/state")},
        gone={"publishers": ("/alarm",)},
        heard={"/gravity": ("geometry_msgs/Vector3", {"x": 1.0, "y": 2.0, "z": 3.0})},
    ),
    Case(
        "fleet.py",
        "fleet",
        "unsubscribe node from '/all/said'\n"
        "node stop_publishing to '/all/hello'\n"
        "node client_requests '/fleet/add' of service_type SetBool with input True\n"
        "node provides_service '/fleet/add' of service_type SetBool\n",
        there={"subscriptions": ("/r1/said", "/r2/said"), "services": ("/fleet/add",)},
        gone={"publishers": ("/all/hello",), "subscriptions": ("/all/said",)},
        prints=("/fleet/add: success: False",),
    ),
]  # fmt: skip


@pytest.mark.parametrize("case", mostly_long(CASES, (), lambda case: case.file))
def test_a_hand_written_node_does_what_the_program_asked(
    case: Case, ros1: Graph, tmp_path: Path
) -> None:
    edited = edit(NODES / case.file, case.program, tmp_path)
    node = ros1.run_and_wait(edited)
    for kind, names in case.there.items():
        for name in names:
            ros1.wait_for_endpoint(case.node, kind, name)
    if case.heard:
        received = ros1.listen({topic: type_ for topic, (type_, _) in case.heard.items()}, 1)
        for topic, (_, fields) in case.heard.items():
            assert [each.message for each in received[topic]] == [fields] * len(received[topic])
    for service, (type_, request, answer) in case.answers.items():
        assert ros1.call(service, type_, request) == answer
    for text in case.prints:
        node.wait_to_print(text)
    found = ros1.endpoints(case.node)
    for kind, names in case.gone.items():
        assert not set(names) & set(found[kind]), found
    assert node.interrupt() == 0
    assert not own_tracebacks(node.output)
