"""Ctrl-C at any moment of a node's start ends it without a traceback."""

from __future__ import annotations

import signal
import time
from pathlib import Path

import pytest
from graph import Graph
from processes import generate, own_tracebacks

pytestmark = pytest.mark.live

# Imports cannot be guarded by the file that makes them: they are over when this says "go".
START = """\
import sys
from pathlib import Path
modules, path = sys.argv[1:]
for module in modules.split():
    __import__(module)
code = compile(Path(path).read_text(), path, "exec")
print("go", flush=True)
exec(code, {"__name__": "__main__"})
"""
MODULES = {
    "rospy": "threading rospy std_msgs.msg std_srvs.srv",
    "rclpy": "time rclpy rclpy.node rclpy.executors std_msgs.msg std_srvs.srv",
}
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
"""Seconds, close together where most happens: from 10 ms to half a second."""

# rospy's signal handler speaks to the master. Where it interrupts the main thread in the midst
# of the same, both wait for one lock, for ever (`rospy.core`, `XmlRpcProxy`): some milliseconds
# of `init_node`, and nothing that a node's file could change.
MOST_DEADLOCKS = {"rospy": 3, "rclpy": 0}

# As `main` does it, but for the end; and a look at what speaks to the master.
CALL = """\
import sys, threading
from pathlib import Path
import rospy
from rospy import core
name, class_name, path = sys.argv[1:]
definitions = {"__name__": "definitions"}
exec(compile(Path(path).read_text(), path, "exec"), definitions)
rospy.init_node(name)
node = definitions[class_name]()
asked = set()
ask = core._LockedServerProxy._ServerProxy__request
def listen(proxy, method, arguments):
    asked.add((method, threading.current_thread() is threading.main_thread()))
    return ask(proxy, method, arguments)
core._LockedServerProxy._ServerProxy__request = listen
node.call_services()
print("asked", *sorted(asked), flush=True)
"""


def test_ctrl_c_while_a_node_starts(graph: Graph, tmp_path: Path) -> None:
    program = tmp_path / "busy.plastron"
    program.write_text(PROGRAM)
    nodes = generate(str(program.with_suffix("")), tmp_path / "output", graph.target)
    start = tmp_path / "start.py"
    start.write_text(START)
    statuses = []
    for delay in DELAYS:
        node = graph.run_with(start, MODULES[graph.target], str(nodes["busy_node.py"]))
        node.wait_to_print("go")
        time.sleep(delay)
        statuses.append(node.interrupt_or_kill(5))
        assert not own_tracebacks(node.output), f"after {delay:.3f} s:\n{node.output}"
    deadlocks = statuses.count(-signal.SIGKILL)
    assert deadlocks <= MOST_DEADLOCKS[graph.target]
    # As rclpy takes the signal over, it may still end the process itself: that is as silent.
    ended = statuses.count(0) + statuses.count(-signal.SIGINT)
    assert ended == len(DELAYS) - deadlocks


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
        text.replace("        return ", "        time.sleep(60)\n        return ").replace(
            "\nimport r", "\nimport time\nimport r", 1
        )
    )
    waiter = nodes["waiter_client.py"]
    waiter.write_text(waiter.read_text().replace("SERVICE_TIMEOUT = 10.0", "SERVICE_TIMEOUT = 2.0"))
    graph.run(mute).wait_to_print("", 1)
    node = graph.run(waiter)
    node.wait_to_print("no answer came in time", 30)
    assert node.interrupt(15) == 0
    assert not own_tracebacks(node.output)


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
    node = graph.run_with(call, "asker", "AskerNode", str(file))
    node.wait_to_print("asked")
    asked = node.output.partition("asked")[2]
    # Each line that is logged asks for a parameter first.
    assert asked.split("\n")[0] == " ('subscribeParam', False)"
