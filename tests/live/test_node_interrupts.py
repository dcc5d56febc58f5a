"""Ctrl-C at any moment of a node's start ends it without a traceback."""

from __future__ import annotations

import re
import signal
import time
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from xmlrpc.client import ServerProxy

import pytest
from graph import Graph
from machine import free_port, mostly_long, wait_until
from processes import Process, generate, own_tracebacks

from plastron_tui.runtime.master import master_pid

pytestmark = pytest.mark.live

# What a file imports and defines cannot be guarded by it: that comes first.
DEFINED = """\
import ast, os, signal, sys
from pathlib import Path
*definitions, guard = ast.parse(Path(sys.argv[1]).read_text()).body
names = {"__name__": "__main__"}
exec(compile(ast.Module(definitions, []), sys.argv[1], "exec"), names)
"""
GUARDED = """\
exec(compile(ast.Module([guard], []), sys.argv[1], "exec"), names)
"""
# It is over when this says "go". Then comes what makes the node, interrupted at the call of a
# function (`*`: any) that has the number.
START = f"""\
{DEFINED}
function, number = sys.argv[2], int(sys.argv[3])
called = 0
def count(frame, event, argument):
    global called
    if event == "call" and function in ("*", frame.f_code.co_name):
        called += 1
        if called == number:
            print("interrupted in", frame.f_code.co_name, flush=True)
            os.kill(os.getpid(), signal.SIGINT)
print("go", flush=True)
if number:
    sys.setprofile(count)
{GUARDED}"""
# Where Ctrl-C breaks off what Python does for a lock, another error takes the interrupt's place.
BROKEN_OFF = f"""\
{DEFINED}
def main():
    try:
        names["rospy"].init_node("broken_off", disable_signals=True)
        raise KeyboardInterrupt
    finally:
        raise RuntimeError("release unlocked lock")
names["main"] = main
{GUARDED}"""
PROGRAM = """\
create_node 'busy' as busy
create_message words of message_type String and input "hello"
busy publish words to 'chatter' of message_type String at 50 hz
subscribe busy to 'chatter' of message_type String
busy provides_service 'ready' of service_type Trigger
busy client_requests 'nobody_is_there' of service_type SetBool with input True
generate_node busy
"""
DELAYS = [0.01 * 1.35**step for step in range(14)]
"""Seconds, close together where most happens: from 10 ms to half a second.

They count from when the test sees what a node says, which is a little after it is said; on a busy
machine it is later. So the moments spread: what is to be hit for certain has a call in `CALLS`.
"""

EVERY_CALL = [("*", 2**power) for power in range(1, 14)]
CALLS = {
    # In the midst of `__request`, rospy holds the lock that what shuts it down takes.
    "rospy": [("main", 1), ("start_node", 1), ("__request", 4)],
    "rclpy": [("main", 1), ("create_publisher", 1), ("spin_once", 9)],
}
"""Where a node is interrupted: a function, and the number of its call."""
MORE_CALLS = {
    "rospy": [*(("__request", number) for number in range(1, 6)), *EVERY_CALL],
    "rclpy": [("init", 1), *EVERY_CALL],
}

# A look at what speaks to the master while the node works.
CALL = """\
import sys, threading
from pathlib import Path
from rospy import core
class_name, path = sys.argv[1:]
definitions = {"__name__": "definitions"}
exec(compile(Path(path).read_text(), path, "exec"), definitions)
node_class = definitions[class_name]
work = node_class.work
asked = set()
ask = core._LockedServerProxy._ServerProxy__request
def listen(proxy, method, arguments):
    asked.add((method, threading.current_thread() is threading.main_thread()))
    return ask(proxy, method, arguments)
def listen_and_work(node):
    core._LockedServerProxy._ServerProxy__request = listen
    work(node)
    # One write: a line of several is seen in parts.
    print(f"asked {sorted(asked)} in all", flush=True)
node_class.work = listen_and_work
definitions["main"]()
"""


def busy_node(graph: Graph, folder: Path) -> tuple[Path, Path]:
    """Generate a node that has some of everything; return what starts it, and its file."""
    program = folder / "busy.plastron"
    program.write_text(PROGRAM)
    nodes = generate(str(program.with_suffix("")), folder / "output", graph.target)
    start = folder / "start.py"
    start.write_text(START)
    return start, nodes["busy_node.py"]


def started(graph: Graph, start: Path, file: Path, function: str, number: int) -> Process:
    """Start a node; a master of ROS 1 would end an earlier one of the same name."""
    name = [f"__name:=n{len(graph.started)}"] if graph.target == "rospy" else []
    return graph.run_with(start, str(file), function, str(number), *name)


def assert_ended(graph: Graph, node: Process, status: int, where: str) -> None:
    """A node ends by itself; rclpy's way of writing one lets an early signal end it, silently."""
    accepted = {"rospy": {0}, "rclpy": {0, -signal.SIGINT}}[graph.target]
    assert status in accepted, f"{where}:\n{node.output}"
    assert not own_tracebacks(node.output), f"{where}:\n{node.output}"


def interrupt_at_calls(graph: Graph, folder: Path, calls: list[tuple[str, int]]) -> None:
    start, file = busy_node(graph, folder)
    nodes = [started(graph, start, file, *call) for call in calls]
    for node, call in zip(nodes, calls, strict=True):
        assert_ended(graph, node, node.wait(60), str(call))
        # rospy speaks to the master in other threads too: how often the main one does, varies.
        assert "interrupted in" in node.output, f"{call}:\n{node.output}"


def interrupt_after(graph: Graph, folder: Path, delays: list[float]) -> None:
    start, file = busy_node(graph, folder)
    for delay in delays:
        node = started(graph, start, file, "*", 0)
        node.wait_to_print("go")
        time.sleep(delay)
        assert_ended(graph, node, node.interrupt(60), f"after {delay:.3f} s")


@pytest.mark.long
def test_ctrl_c_at_a_call(graph: Graph, tmp_path: Path) -> None:
    interrupt_at_calls(graph, tmp_path, CALLS[graph.target])


@pytest.mark.long
def test_ctrl_c_at_many_calls(graph: Graph, tmp_path: Path) -> None:
    calls = MORE_CALLS[graph.target]
    for index in range(0, len(calls), 3):
        interrupt_at_calls(graph, tmp_path, calls[index : index + 3])


def test_an_error_that_ctrl_c_made(ros1: Graph, tmp_path: Path) -> None:
    start, file = busy_node(ros1, tmp_path)
    start.write_text(BROKEN_OFF)
    node = ros1.run_with(start, str(file))
    assert_ended(ros1, node, node.wait(60), "in a lock")


def test_ctrl_c_while_a_node_starts(graph: Graph, tmp_path: Path) -> None:
    interrupt_after(graph, tmp_path, DELAYS[3::7])


@pytest.mark.long
def test_ctrl_c_at_many_moments_of_the_start(graph: Graph, tmp_path: Path) -> None:
    interrupt_after(graph, tmp_path, DELAYS[::2])


# Ctrl-C comes while a timer has its turn; its topic is closed while it sends.
AT_ITS_TURN = f"""\
{DEFINED}
import time
rospy = names["rospy"]
publish = rospy.Publisher.publish
def late(publisher, *message):
    if publisher.name == "/chatter":
        rospy.Publisher.publish = publish
        print("its turn", flush=True)
        os.kill(os.getpid(), signal.SIGINT)
        while not rospy.is_shutdown():
            time.sleep(0.01)
        # What rospy raises where it closes the connections at the same time.
        raise rospy.ROSException("topic was closed during publish()")
    publish(publisher, *message)
rospy.Publisher.publish = late
{GUARDED}"""


def test_ctrl_c_at_the_turn_of_a_timer(ros1: Graph, tmp_path: Path) -> None:
    start, file = busy_node(ros1, tmp_path)
    start.write_text(AT_ITS_TURN)
    node = ros1.run_with(start, str(file))
    assert_ended(ros1, node, node.wait(60), "at the turn of a timer")
    assert "its turn" in node.output
    assert "Traceback" not in node.output, node.output


CLOSING = """\
    def closing():
        print("closing", flush=True)
        threading.Event().wait()

    import threading
    rospy.on_shutdown(closing)
    rospy.spin()
"""


def listener(graph: Graph, folder: Path) -> Path:
    program = folder / "listener.plastron"
    program.write_text(
        "create_node 'listener' as listener\n"
        "subscribe listener to 'chatter' of message_type String\n"
        "generate_node listener\n"
    )
    output = folder / "output"
    return generate(str(program.with_suffix("")), output, graph.target)["listener_sub1.py"]


def test_a_second_ctrl_c_ends_a_node_at_once(ros1: Graph, tmp_path: Path) -> None:
    file = listener(ros1, tmp_path)
    file.write_text(file.read_text().replace("    rospy.spin()\n", CLOSING))
    start = tmp_path / "start.py"
    start.write_text(START)
    node = ros1.run_with(start, str(file), "spin", "1")
    node.wait_to_print("closing", 60)
    assert node.interrupt(60) == -signal.SIGINT, node.output
    assert not own_tracebacks(node.output)


@pytest.mark.parametrize("graph", mostly_long(["ros1", "ros2"], ["ros2"]), indirect=True)
def test_a_node_ends_when_it_is_terminated(graph: Graph, tmp_path: Path) -> None:
    start = tmp_path / "start.py"
    start.write_text(START.replace("signal.SIGINT", "signal.SIGTERM"))
    # In `rclpy.spin`, the executor would be half made.
    spin = {"rospy": "spin", "rclpy": "spin_once"}[graph.target]
    node = graph.run_with(start, str(listener(graph, tmp_path)), spin, "1")
    assert node.wait(60) == 0, node.output
    assert not own_tracebacks(node.output)


@pytest.mark.long
def test_ctrl_c_while_there_is_no_master(ros1: Graph, tmp_path: Path) -> None:
    env = {**ros1.env, "ROS_MASTER_URI": f"http://127.0.0.1:{free_port()}/"}
    start = tmp_path / "start.py"
    start.write_text(START)
    file = listener(ros1, tmp_path)
    node = replace(ros1, env=env).run_with(start, str(file), "start_node", "1")
    assert node.wait(60) == 0, node.output
    assert not own_tracebacks(node.output)


@pytest.mark.parametrize(
    "number", mostly_long([signal.SIGINT, signal.SIGTERM], ["SIGINT"], lambda one: one.name)
)
def test_ctrl_c_while_the_master_is_gone(
    ros1: Graph, tmp_path: Path, number: signal.Signals
) -> None:
    """rospy then holds the lock of all topics while it tries to register another one."""
    uri = f"http://127.0.0.1:{(port := free_port())}/"
    graph = replace(ros1, env={**ros1.env, "ROS_MASTER_URI": uri})
    master = Process(["/usr/bin/rosmaster", "--core", "-p", str(port)], graph.env, tmp_path / "log")
    ros1.started.append(master)
    wait_until(lambda: master_pid(uri) is not None, "the master answers", 60)
    file = listener(graph, tmp_path)
    gone = tmp_path / "gone"
    waiting = f"""\
        import os, time
        print("joined", flush=True)
        while not os.path.exists("{gone}"):
            time.sleep(0.01)
"""
    subscribing = "        rospy.Subscriber("
    file.write_text(file.read_text().replace(subscribing, waiting + subscribing))
    node = graph.run(file)
    node.wait_to_print("joined", 60)
    master.interrupt(20)
    gone.touch()
    wait_until(
        lambda: "Unable to register" in node.output.partition("joined")[2], "it cannot register", 60
    )
    node.send(number)
    assert node.wait(60) == 0, node.output
    assert not own_tracebacks(node.output)


def test_rosnode_kill_ends_a_node(ros1: Graph, tmp_path: Path) -> None:
    node = ros1.run(listener(ros1, tmp_path))
    master = ServerProxy(ros1.env["ROS_MASTER_URI"])

    def listening() -> ServerProxy | None:
        # Of a node that was killed, the master may still have the address.
        with suppress(OSError):
            asked = ServerProxy(str(master.lookupNode("/test", "/listener")[2]))
            if asked.getPid("/test")[2] == node.pid and asked.getSubscriptions("/test")[2]:
                return asked
        return None

    wait_until(listening, "the node listens", 60).shutdown("/test", "as `rosnode kill` does it")
    assert node.wait(60) == 0, node.output
    assert not own_tracebacks(node.output)
    assert "/listener" not in str(master.getSystemState("/test"))


PATIENCE = re.compile(r"(\.join\(|self\.create_timer\()SERVICE_TIMEOUT\b")
"""Where a node says how long it waits for an answer."""


@pytest.mark.long
def test_ctrl_c_while_a_service_does_not_answer(graph: Graph, tmp_path: Path) -> None:
    program = tmp_path / "waits.plastron"
    program.write_text(
        "create_node 'mute' as mute\n"
        "mute provides_service 'ready' of service_type Trigger calling never\n"
        "generate_node mute\n"
        "create_node 'waiter' as waiter\n"
        "waiter client_requests 'ready' of service_type Trigger with input none\n"
        "waiter client_requests 'ready' of service_type Trigger with input none\n"
        "generate_node waiter\n"
    )
    nodes = generate(str(program.with_suffix("")), tmp_path / "output", graph.target)
    mute = nodes["mute_server.py"]
    text = mute.read_text()
    mute.write_text(
        text.replace("        return ", "        time.sleep(600)\n        return ").replace(
            "\nimport r", "\nimport time\nimport r", 1
        )
    )
    waiter = nodes["waiter_client.py"]
    text, count = PATIENCE.subn(r"\1next(patience)", waiter.read_text())
    assert count == 1
    # Ctrl-C is to come while the second answer is waited for, however slow the machine is.
    patience = "SERVICE_TIMEOUT = 600.0\npatience = iter([1.0, 600.0])"
    waiter.write_text(text.replace("SERVICE_TIMEOUT = 10.0", patience))
    graph.run(mute)
    graph.wait_for_endpoint("mute", "services", "/ready")
    node = graph.run(waiter)
    node.wait_to_print("no answer came in time")
    assert_ended(graph, node, node.interrupt(), "while it waits")


@pytest.mark.long
@pytest.mark.parametrize("graph", ["ros1"], indirect=True)
def test_what_calls_services_leaves_the_main_thread_free(graph: Graph, tmp_path: Path) -> None:
    program = tmp_path / "asks.plastron"
    program.write_text(
        "create_node 'asker' as asker\n"
        "asker client_requests 'nobody' of service_type Trigger with input none\n"
        "generate_node asker\n"
    )
    file = generate(str(program.with_suffix("")), tmp_path / "output", graph.target)[
        "asker_client.py"
    ]
    file.write_text(file.read_text().replace("SERVICE_TIMEOUT = 10.0", "SERVICE_TIMEOUT = 1.0"))
    call = tmp_path / "call.py"
    call.write_text(CALL)
    node = graph.run_with(call, "AskerNode", str(file))
    node.wait_to_print(" in all\n")
    # Each line that is logged asks for a parameter first.
    assert "asked [('subscribeParam', False)] in all\n" in node.output
