"""What the reports of a monitor add up to, and the process that makes them."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from machine import wait_until
from supervised import all_gone

from plastron_tui.runtime import monitor as monitors
from plastron_tui.runtime.environment import Environment, Origin
from plastron_tui.runtime.live_graph import MOST_SAMPLES, NOT_WATCHED, SHOWN_GONE, LiveGraph
from plastron_tui.runtime.monitor import (
    Monitor,
    MonitorCommand,
    announced,
    announcement,
    monitor_commands,
)
from plastron_tui.runtime.monitor_reports import Reports

GRAPH = {
    "tell": "graph",
    "topics": [["/chatter", "std_msgs/String", 1, 2], ["/speed", "std_msgs/Float64", 1, 0]],
    "services": [["/add", "a/Add"]],
    "nodes": ["/talker", "/listener"],
}


def row(count: int, **more: Any) -> dict[str, Any]:
    return {"count": count, "rate": 2.0, "text": str(count), "number": count, **more}


def test_reports_add_up() -> None:
    graph = LiveGraph(2)
    assert graph.feed(GRAPH) and graph.is_known
    for count in range(1, MOST_SAMPLES + 10):
        fields = [["data", str(count), count], ["unit", '"m"', None]]
        assert graph.feed({"tell": "topics", "rows": {"/speed": row(count, fields=fields)}})
    topic = graph.topics["/speed"]
    assert (topic.rate, topic.text, len(topic.samples)) == (2.0, topic.fields[0].text, MOST_SAMPLES)
    assert list(topic.field_samples) == ["data"] and topic.field_samples["data"][-1] == topic.count
    # The same message again is no new number.
    graph.feed({"tell": "topics", "rows": {"/speed": row(topic.count) | {"number": -1}}})
    assert -1 not in topic.samples and not topic.fields
    # A topic of which the graph does not know is none.
    graph.feed({"tell": "topics", "rows": {"/other": row(1)}})
    assert list(graph.topics) == ["/chatter", "/speed"]


def test_what_has_gone_stays_and_is_marked() -> None:
    graph = LiveGraph(2)
    graph.feed(GRAPH)
    graph.feed({"tell": "topics", "rows": {"/chatter": row(3)}})
    graph.feed({**GRAPH, "topics": GRAPH["topics"][1:], "services": [], "nodes": ["/listener"]})
    topic = graph.topics["/chatter"]
    assert topic.is_gone and topic.rate == 0 and topic.text == "3"
    assert graph.services["/add"].is_gone
    assert graph.nodes == {"/listener": True, "/talker": False}
    graph.feed(GRAPH)
    assert not graph.topics["/chatter"].is_gone and graph.nodes["/talker"]
    # What is not of the program in front is forgotten some seconds after it was missed.
    graph.feed({**GRAPH, "topics": [], "services": [], "nodes": ["/listener"]})
    missed = graph.gone_since["node /talker"]
    graph.feed({**GRAPH, "topics": [], "services": [], "nodes": ["/listener"]})
    assert set(graph.gone_since.values()) == {missed}
    assert {key.split()[0] for key in graph.gone_since} == {"topic", "service", "node"}
    later = missed + SHOWN_GONE
    assert not graph.is_past("node /talker", ["/talker"], later)
    graph.own = frozenset({"/listener"})
    assert graph.is_past("node /talker", ["/talker"], later)
    assert not graph.is_past("node /talker", ["/talker"], later - 0.1)
    assert not graph.is_past("node /listener", ["/listener"], later)
    # What was seen last stays when all nodes have ended, but not beside other programs.
    graph.end()
    assert graph.is_shown
    graph.own = frozenset()
    assert not graph.is_shown


def test_what_is_sent_is_known_until_it_ends_or_the_monitor_does() -> None:
    graph = LiveGraph(2)
    action = ["/count", "p/Count", 1, ["/talker"]]
    graph.feed({**GRAPH, "actions": [action], "services": [["/add", "a/Add", ["/talker"]]]})
    assert graph.actions["/count"] == (*action[:3], frozenset({"/talker"}), False)
    assert graph.services["/add"].nodes == {"/talker"}
    sending = {"tell": "sending", "name": "/speed", "rate": 10, "text": "1.0"}
    assert graph.feed(sending) and graph.sendings["/speed"] == (10, "1.0", "")
    assert graph.feed({**sending, "rate": 0, "problem": "no"})
    assert graph.sendings["/speed"].problem == "no"
    assert graph.feed({**sending, "rate": 0}) and not graph.sendings
    goal = {"tell": "goal", "name": "/count", "sent": "order: 5", "state": "accepted",
            "text": "", "is_over": False, "is_failure": False}  # fmt: skip
    for number in range(1, 150):
        assert graph.feed({**goal, "id": number, "is_over": number < 149})
    assert len(graph.goals) <= 100 and graph.goals[149].state == "accepted"
    assert not graph.feed({"tell": "goal", "id": 1})
    graph.feed(sending)
    graph.lose_monitor()
    assert not graph.sendings and graph.goals[149].is_over
    assert graph.goals[149].state == NOT_WATCHED and graph.goals[148].state == "accepted"
    graph.feed(GRAPH)
    assert graph.actions["/count"].is_gone


def test_parameters_are_those_of_the_last_report() -> None:
    graph = LiveGraph(2)
    told = {"name": "speed", "value": 0.5, "type": "float", "range": [0, 1], "about": "m/s",
            "is_read_only": False}  # fmt: skip
    for value in (0.5, [1, 2]):
        graph.feed({"tell": "parameters", "node": "/a", "rows": [{**told, "value": value}]})
    (found,) = graph.parameters["/a"]
    assert (found.value, found.range, found.about) == ((1, 2), (0.0, 1.0), "m/s")


@pytest.mark.parametrize(
    "report",
    [{}, {"tell": "graph"}, {"tell": "graph", "topics": 3, "services": [], "nodes": []},
     {"tell": "topics", "rows": {"/chatter": {"count": "many"}}}, {"tell": "topics", "rows": [1]},
     {"tell": "topics", "rows": {"/chatter": {"count": float("inf")}}},
     {"tell": "parameters", "node": "/a", "rows": [{}]}, {"tell": "beat"}, {"tell": ["x"]}],
)  # fmt: skip
def test_what_is_no_report_changes_nothing(report: Mapping[str, Any]) -> None:
    graph = LiveGraph(2)
    graph.feed(GRAPH)
    assert not graph.feed(report)
    assert list(graph.topics) == ["/chatter", "/speed"]


def test_what_starts_monitors_is_told_in_a_line() -> None:
    commands = (
        MonitorCommand(1, ("a", "b"), {"X": "ü\n"}),
        MonitorCommand(2, ("c",), {}, {"talker": ("/a/talker",)}),
    )
    line = announcement(commands)
    assert line.count("\n") == 1 and announced(line) == commands
    for wrong in ("", "[1]", "{}", "[{}]", "nonsense"):
        assert announced(wrong) == ()


def test_nodes_of_one_generation_have_one_monitor_that_knows_the_types_of_all() -> None:
    plain = Environment(Origin.SOURCED, 2, "kilted", Path("python3"))
    built = replace(plain, overlays=(Path("/built"),))
    own = ("AMENT_PREFIX_PATH", Path("/own"))
    old = Environment(Origin.DEBIAN, 1, "noetic", Path("python3.8"))

    def environ_of(environment: Environment) -> dict[str, str]:
        return {"OVERLAYS": " ".join(map(str, environment.overlays)), "AMENT_PREFIX_PATH": "/opt"}

    for used in ([(plain, ()), (built, [own])], [(built, [own]), (plain, ())]):
        (first, second) = monitor_commands([*used, (old, ()), *used], environ_of)
        assert (first.ros_version, second.ros_version) == (2, 1)
        assert first.environ == {"OVERLAYS": "/built", "AMENT_PREFIX_PATH": "/own:/opt"}
        assert second.environ == environ_of(old)
        assert second.command[0] == "python3.8"


def test_what_nobody_takes_is_replaced_and_never_lost() -> None:
    reports = Reports()
    assert reports.add({"tell": "graph", "topics": []}) and reports.add(GRAPH)
    assert reports.add({"tell": "problem", "text": "no network"})
    answers = [{"tell": "answer", "id": number} for number in range(3)]
    parameters = [{"tell": "parameters", "node": node, "rows": []} for node in ("/a", "/b", "/a")]
    sendings = [{"tell": "sending", "name": "/a", "rate": rate, "text": ""} for rate in (5, 0)]
    goals = [{"tell": "goal", "id": number} for number in (1, 2, 1)]
    for report in (*answers, *parameters, *sendings, *goals):
        assert reports.add(report)
    for count in range(5000):
        reports.add({"tell": "topics", "rows": {"/speed": row(count)}})
        assert not reports.add({"tell": "beat"})
    reports.add({"tell": "topics", "rows": {"/chatter": row(1)}})
    rows = {"/speed": row(4999), "/chatter": row(1)}
    problem = {"tell": "problem", "text": "no network"}
    assert reports.take() == [GRAPH, problem, {"tell": "topics", "rows": rows},
                              parameters[2], parameters[1], sendings[1], goals[2], goals[1],
                              *answers]  # fmt: skip
    assert reports.take() == []
    # A graph says that there is no problem any more.
    reports.add(problem)
    reports.add(GRAPH)
    assert reports.take() == [GRAPH]
    for nonsense in ({}, {"tell": "topics", "rows": 1}, {"tell": ["x"]}, {"tell": "parameters"}):
        assert not reports.add(nonsense)


def started(script: str) -> tuple[Monitor, threading.Event]:
    told = threading.Event()
    command = MonitorCommand(2, (sys.executable, "-c", script), dict(os.environ))
    return Monitor(command, told.set), told


def test_a_monitor_is_heard_and_ends_with_its_orders(monkeypatch: pytest.MonkeyPatch) -> None:
    monitor, told = started(
        "import sys\nprint('noise\\n[1]\\n', flush=True)\n"
        "for line in sys.stdin: print(line.replace('do', 'tell'), end='', flush=True)"
    )
    assert monitor.order(do="answer", topics=["/a"])
    assert told.wait(60)
    found: list[Any] = []
    wait_until(lambda: found.extend(monitor.take()) or found, "the order comes back", 60)
    assert found == [{"tell": "answer", "topics": ["/a"]}]
    assert not monitor.is_silent
    monkeypatch.setattr(monitors, "SILENT", 0.0)
    assert monitor.is_silent
    monitor.close()
    wait_until(lambda: monitor.ended is not None, "it ends", 60)
    assert not monitor.order(do="watch")


def test_what_a_slow_monitor_did_not_read_is_written_later() -> None:
    monitor, _ = started(
        'import sys\nsys.stdin.read(1)\nprint(\'{"tell": "answer"}\', flush=True)\n'
        'print(\'{"tell": "answer", "id": %d}\' % sum(1 for _ in sys.stdin), flush=True)'
    )
    # More than a pipe holds: it reads no more until it is told to go on.
    for _ in range(20):
        assert monitor.order(do="x" * 10_000)
    wait_until(lambda: not monitor.take() and not monitor._unsent, "all is written", 60)
    monitor._orders.close()
    wait_until(lambda: {"tell": "answer", "id": 20} in monitor.take(), "all has come", 60)
    monitor.close()


def test_why_a_monitor_ended_is_known() -> None:
    # What it says last is read some time after it has ended.
    script = (
        "import os, time\nif os.fork(): os._exit(1)\n"
        "os.close(1)\ntime.sleep(0.2)\nos.write(2, b'noise\\nno such ROS\\n')"
    )
    monitor, _ = started(script)
    wait_until(lambda: monitor.ended is not None, "it ends", 60)
    assert monitor.ended == "no such ROS"


def test_one_that_hangs_keeps_nobody_waiting(monkeypatch: pytest.MonkeyPatch) -> None:
    monitor, _ = started("import time; time.sleep(600)")
    try:
        # Far more than a pipe holds; in the end it is refused.
        wait_until(lambda: not monitor.order(do="x" * 100_000), "it is refused", 60)
        # It may take its time until it says the first word.
        monkeypatch.setattr(monitors, "SILENT", 0.0)
        assert not monitor.is_silent
        monkeypatch.setattr(monitors, "SLOWEST_START", 0.0)
        assert monitor.is_silent
    finally:
        monitor.kill()
    wait_until(lambda: monitor.ended is not None, "it ends", 60)


STUDIO = """
import os, signal, sys
from plastron_tui.runtime.monitor import Monitor, MonitorCommand
script = "import os, signal; os.kill(os.getpid(), signal.SIGSTOP)"
monitor = Monitor(MonitorCommand(2, (sys.executable, "-c", script), dict(os.environ)), print)
print(monitor._process.pid, flush=True)
os.waitid(os.P_PID, monitor._process.pid, os.WSTOPPED | os.WNOWAIT)
monitor.close()
os.kill(os.getpid(), signal.SIGKILL)
"""


def test_a_monitor_that_is_stopped_ends_with_who_started_it() -> None:
    studio = subprocess.run([sys.executable, "-c", STUDIO], stdout=subprocess.PIPE, check=False)
    assert studio.returncode == -signal.SIGKILL
    pid = int(studio.stdout)
    all_gone(pid)


def test_monitors_of_several_runs_know_the_types_of_all_of_them() -> None:
    newer = MonitorCommand(2, ("a",), {"PYTHONPATH": "/own:/opt", "HOME": "/h"}, {"t": ("/t",)})
    older = MonitorCommand(2, ("b",), {"PYTHONPATH": "/older:/opt", "HOME": "/g"})
    (both,) = monitors.joined([[newer], [older]])
    assert (both.command, both.environ["HOME"], both.nodes) == (("a",), "/h", {})
    assert both.environ["PYTHONPATH"].split(":") == ["/own", "/opt", "/older"]
    assert monitors.joined([[newer]]) == (replace(newer, nodes={}),)
    one = MonitorCommand(1, ("c",), {})
    assert monitors.joined([[one], [newer]]) == (one, replace(newer, nodes={}))
