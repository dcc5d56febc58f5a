"""Nodes of ROS 1 in C++ do what those in Python do, seen by who knows nothing of Plastron."""

from __future__ import annotations

import re
import signal
from dataclasses import replace
from pathlib import Path
from xmlrpc.client import ServerProxy

import pytest
from cpp_builds import find_roscpp
from cpp_nodes import MANAGER, CppGraph, CppProcess, nodelet_of, plugin_environ
from graph import Graph, is_rate, rate
from machine import wait_until
from processes import PROGRAMS, Process
from roscpp_builds import generate_cpp, headers, locked
from test_goals import FEEDBACK, RESULT, TYPE, outcomes, peer, send, told
from test_parameters import BAD, GOOD, TYPES, values
from test_reactions import STEPS, assert_reflexes
from traffic import record

pytestmark = [pytest.mark.live, pytest.mark.long]

CHATTER = """\
create_message hello of message_type String and input "hello"
node publish hello to 'chatter' of message_type String at 10 hz
node provides_action 'count' of action_type Fibonacci
node client_requests 'ready' of service_type Trigger with input none at 5 hz
"""
MORE = """\
node publish hello to '~/mine' of message_type String at 10 hz
node publish hello to 'first' of message_type String once
subscribe node to 'a' of message_type String calling hear
subscribe node to 'b' of message_type Int32 calling hear
node sends_goal to 'other' of action_type Fibonacci with input order=5
node client_requests 'enable_motor' of service_type SetBool with input True
"""
PILOT = """\
node client_requests 'enable_motor' of service_type SetBool with input True
node client_requests 'ready' of service_type Trigger with input none
node sends_goal to 'count' of action_type Fibonacci with input order=5
"""


def _program(name: str, statements: str, library: str) -> str:
    file = PROGRAMS / f"{name}.plastron"
    lines = file.read_text().splitlines(keepends=True)[1:-1] if file.exists() else []
    own = "".join(lines).replace(f"subscribe {name} ", "subscribe node ")
    own = "".join(
        line.replace(f"{name} ", "node ", 1) if line.startswith(name) else line
        for line in own.splitlines(keepends=True)
    )
    return f"create_node '{name}' as node\n{own}{statements}generate_node node using {library}\n"


NODES = {
    "reflex": (_program("reflex", CHATTER + MORE, "roscpp"), "single"),
    "pilot": (_program("pilot", PILOT, "roscpp"), "split"),
    "cruiser": (_program("cruiser", CHATTER, "nodelet"), "split"),
}
"""The programs, and whether a class has a header of its own."""

COMPLAINT = re.compile(r"^\[(?:WARN|ERROR|FATAL)\]|terminate called", re.MULTILINE)


class Programs:
    """The nodes as programs and libraries, each compiled once for all workers."""

    def __init__(self, cache: Path, factory: pytest.TempPathFactory) -> None:
        self._cache = cache
        self._roscpp = find_roscpp(factory).beside(headers(cache))

    def __getitem__(self, name: str) -> Path:
        program, layout = NODES[name]
        is_plugin = name == "cruiser"
        folder = self._cache / "cpp" / name
        with locked(folder):
            if not (folder / "made").exists():
                file = generate_cpp(program, folder / "files", layout)
                # Who waits for an answer is not to keep the tests waiting.
                file.write_text(file.read_text().replace("TIMEOUT = 10.0", "TIMEOUT = 2.0"))
                made = folder / name
                if is_plugin:
                    library, _ = nodelet_of(self.package(name))
                    made = folder / "lib" / f"{library}.so"
                    made.parent.mkdir()
                own = [self.package(name) / "include"]
                self._roscpp.compile(made, file, headers=own, is_shared=is_plugin)
                (folder / "made").touch()
        return folder / name

    def package(self, name: str) -> Path:
        return self._cache / "cpp" / name / "files" / "output"


@pytest.fixture(scope="session")
def programs(shared_cache: Path, tmp_path_factory: pytest.TempPathFactory) -> Programs:
    return Programs(shared_cache, tmp_path_factory)


@pytest.fixture
def cpp(ros1: Graph) -> CppGraph:
    """A graph of ROS 1 whose nodes are in C++."""
    parts = (ros1.python, ros1.probe, ros1.env, ros1.folder, ros1.started)
    return CppGraph("rospy", *parts)


def end(*nodes: Process, by: signal.Signals = signal.SIGINT) -> None:
    """Ctrl-C, or what a service manager sends, ends nodes with status 0; nobody complains."""
    for each in nodes:
        before = len(COMPLAINT.findall(each.output))
        each.send(by)
        assert each.wait(20) == 0, each.output
        assert len(COMPLAINT.findall(each.output)) == before, each.output


def test_what_follows_from_a_message(cpp: CppGraph, programs: Programs) -> None:
    causes = {name for step in STEPS for name in (step.name, *step.causes)}
    traffic = record(replace(cpp, wanted=causes), programs["reflex"], STEPS, {})
    assert_reflexes(traffic)


def test_a_node_and_its_peers(cpp: CppGraph, programs: Programs) -> None:
    """It answers goals, and sends one, and calls services, and all that goes on at once."""
    wanted = ["/count/goal", "/chatter", "/first", "/reflex/mine", "/a", "/b", "/other/goal"]
    node = replace(cpp, wanted=wanted).run_and_wait(programs["reflex"])
    node.wait_to_print("first: nobody listens yet")
    asked = peer(cpp, "answer", 0.1)
    served = peer(cpp, "serve", "other", TYPE["rospy"], "succeed", FEEDBACK, RESULT)
    node.wait_to_print("/ready: ", count=3)
    node.wait_to_print("/enable_motor: ")
    node.wait_to_print("other: succeeded: ")
    assert told(served, "goal") == told(served, "goal", goal={"order": 5})
    assert {each["flying"] for each in told(asked, "request", service="ready")} == {1}
    assert told(asked, "request", service="enable_motor", request={"data": True})
    heard = cpp.listen({"/first": "std_msgs/String", "/reflex/mine": "std_msgs/String"}, 0.5)
    assert [each.message for each in heard["/first"]] == [{"data": "hello"}]
    assert outcomes(send(cpp, cancel_at=2)) == {0: "preempted"}
    assert outcomes(send(cpp, second_at=2)) == {0: "preempted", 1: "succeeded"}
    # What works on a goal tells its client that the node ends.
    sender = send(cpp)
    wait_until(lambda: told(sender, "feedback"), "a feedback")
    end(node, by=signal.SIGTERM)
    assert outcomes(sender) == {0: "aborted"}


def test_a_node_that_ends_after_its_calls(cpp: CppGraph, programs: Programs) -> None:
    pilot = programs["pilot"]
    alone = cpp.run(pilot)
    alone.wait_to_print("/enable_motor: nobody serves it")
    alone.wait_to_print("/ready: nobody serves it")
    end(alone, by=signal.SIGTERM)
    mute = peer(cpp, "answer", 600)
    mute.wait_to_print('"serving"')
    server = peer(cpp, "serve", "count", TYPE["rospy"], "abort", FEEDBACK, RESULT)
    server.wait_to_print('"serving"')
    failing = cpp.run(pilot)
    failing.wait_to_print("/enable_motor: no answer came in time")
    failing.wait_to_print("/ready: no answer came in time")
    failing.wait_to_print("count: aborted: ")
    assert failing.wait(30) == 1, failing.output
    waiting = cpp.run(pilot)
    wait_until(lambda: len(told(mute, "request", service="enable_motor")) == 2, "a call")
    end(waiting)
    mute.kill()
    server.kill()
    peer(cpp, "answer", 0).wait_to_print('"serving"')
    peer(cpp, "serve", "count", TYPE["rospy"], "succeed", FEEDBACK, RESULT)
    served = cpp.run(pilot)
    assert served.wait(60) == 0, served.output
    assert "count: succeeded: " in served.output


def test_ctrl_c_while_there_is_no_master(cpp: CppGraph, programs: Programs) -> None:
    env = {**cpp.env, "ROS_MASTER_URI": "http://127.0.0.1:9/"}
    node = replace(cpp, env=env).run(programs["reflex"])
    node.wait_to_print("Failed to contact master")
    assert node.interrupt(20) == 0, node.output


@pytest.fixture
def manager(cpp: CppGraph, programs: Programs) -> CppGraph:
    """A graph in which the nodelet can be loaded."""
    prefix = programs["cruiser"].parent
    env = {**cpp.env, **plugin_environ(programs.package("cruiser"), prefix)}
    return replace(cpp, env=env, wanted=["/count/goal", "/chatter", *TYPES])


def nodelet(graph: CppGraph, *arguments: str) -> CppProcess:
    log = graph.folder / f"{arguments[0]}.log"
    process = CppProcess([MANAGER, *arguments], graph.env, log)
    graph.started.append(process)
    return process


def test_a_nodelet_in_a_manager(manager: CppGraph, programs: Programs) -> None:
    _, class_ = nodelet_of(programs.package("cruiser"))
    # With a bond, a manager that ends while one breaks unloads by way of what it has not any more.
    loading = ("load", class_, "manager", "--no-bond", "__name:=cruiser")
    host = nodelet(manager, "manager", "__name:=manager")
    loaded = nodelet(manager, *loading)
    manager.described("manager")
    master = ServerProxy(manager.env["ROS_MASTER_URI"])
    for name, value in GOOD.items():
        master.setParam("/test", f"/cruiser/{name}", value)
    wait_until(lambda: values(manager.listen(TYPES, 0.1)) == GOOD, "the new values", 60)
    for name, bad in BAD.items():
        for value in bad:
            master.setParam("/test", f"/cruiser/{name}", value)
    host.wait_to_print("gear is not an integer from -1 to 5")
    assert values(manager.listen(TYPES, 0.5)) == GOOD
    master.setParam("/test", "/cruiser/rate", 50.0)
    topic = {"/cmd_vel": TYPES["/cmd_vel"]}
    wait_until(lambda: is_rate(rate(manager.listen(topic, 2)["/cmd_vel"]), 50), "the new rate", 60)
    peer(manager, "answer", 0.1)
    host.wait_to_print("/ready: ", count=2)
    sender = send(manager)
    wait_until(lambda: told(sender, "feedback"), "a feedback")
    end(loaded)
    assert outcomes(sender) == {0: "aborted"}
    # It was aborted by the nodelet, and not by actionlib, which complains.
    assert "terminal status" not in host.output
    called = host.output.count("/ready: ")
    nodelet(manager, *loading)
    host.wait_to_print("/ready: ", count=called + 2)
    end(host)
