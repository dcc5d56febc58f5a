"""One interface to a running ROS graph of either generation, for the tests."""

from __future__ import annotations

import json
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import count
from pathlib import Path
from typing import Any

from machine import wait_until
from probes import ask
from processes import Process


@dataclass(frozen=True)
class Received:
    """What came over a topic: when (in seconds, of one clock), and the fields."""

    time: float
    message: dict[str, Any]


def rate(received: Sequence[Received]) -> float:
    """Return how often messages came, in hertz.

    What had queued up when the listener began to listen comes at once, and does not count.
    """
    return rate_of([each.time for each in received if each.time > received[0].time + 0.5])


def rate_of(times: Sequence[float]) -> float:
    """Return how often something happened, in hertz, by its times in seconds."""
    return (len(times) - 1) / (times[-1] - times[0])


def is_rate(measured: float, hertz: float) -> bool:
    """Tell whether a rate is the one that was asked for, on however busy a machine.

    There, less is sent, and what was held up comes at once; but nothing comes twice as often.
    """
    return hertz / 4 < measured < hertz * 1.6


@dataclass
class Graph:
    """Starts nodes and probes in one ROS graph.

    `python` is the interpreter that has ROS, `probe` the script that speaks to the graph.
    """

    target: str
    python: Path
    probe: Path
    env: Mapping[str, str]
    folder: Path
    started: list[Process]
    _numbers: count[int] = field(default_factory=count)

    def run(self, node: Path) -> Process:
        """Start a node's file."""
        return self._start([self.python, "-u", node], node.stem)

    def run_and_wait(self, node: Path) -> Process:
        """Start a node's file, and wait until the node has set up all that it is to have."""
        process = self.run_with(Path(__file__).with_name("set_up.py"), str(node))
        process.wait_to_print("all is set up")
        return process

    def run_program(
        self, program: Path, *arguments: str, environ: Mapping[str, str] | None = None
    ) -> Process:
        """Start a node that is a program, with variables of its own."""
        log = self.folder / f"{next(self._numbers)}-{program.name}.log"
        process = Process([program, *arguments], {**self.env, **(environ or {})}, log)
        self.started.append(process)
        return process

    def run_with(self, script: Path, *arguments: str) -> Process:
        """Start a script of the test's own, which runs a node in its own way."""
        return self._start([self.python, "-u", script, *arguments], script.stem)

    def listen(
        self,
        topics: Mapping[str, str],
        seconds: float,
        qos: Sequence[str] = (),
        *,
        silent: Collection[str] = (),
    ) -> dict[str, list[Received]]:
        """Return what comes over topics, by name.

        Args:
            topics: the type of each.
            seconds: how long, from the first message of the last topic to have one.
            qos: `transient_local`, `best_effort`, `deadline` (a second), `manual_by_topic`: what
                the subscriptions ask for, in ROS 2.
            silent: topics that need not have a message, only a publisher.
        """
        arguments = map(json.dumps, (topics, seconds, list(qos), list(silent)))
        said = self._said("listen", *arguments, seconds=seconds + 120)
        found: dict[str, list[Received]] = {topic: [] for topic in topics}
        for line in said.splitlines():
            if line.startswith('{"topic"'):
                entry = json.loads(line)
                found[entry["topic"]].append(Received(entry["time"], entry["message"]))
        return found

    def call(self, service: str, type_: str, request: Mapping[str, Any]) -> dict[str, Any]:
        """Call a service and return its response."""
        return self._ask("call", service, type_, json.dumps(request))

    def set_parameter(self, node: str, name: str, value: Any) -> str | None:
        """Set a parameter of a node; return the reason for which it was refused."""
        result = self._ask("set", node, name, json.dumps(value))
        return None if result["successful"] else result["reason"]

    def lifecycle(self, node: str, steps: Sequence[tuple[str, Mapping[str, int] | None]]) -> Any:
        """Pass transitions of a managed node of ROS 2.

        Args:
            node: its name.
            steps: the transitions, and how many endpoints of each kind and name are to be there
                after each, None where that is not waited for.

        Returns:
            a list for each: the transition, whether it succeeded, the state, the endpoints.
        """
        return self._ask("lifecycle", node, json.dumps(steps))

    def load_component(self, container: str, package: str, class_: str, node: str) -> str:
        """Load a class of a package into a container of ROS 2; return the node's full name."""
        return str(self._ask("load", container, package, class_, node))

    def endpoints(self, node: str) -> dict[str, list[str]]:
        """Return what a node publishes, subscribes and provides, as the graph itself says."""
        return self._ask("endpoints", node)

    def _ask(self, command: str, *arguments: str) -> Any:
        """Return what a command of the probe prints at last."""
        return json.loads(self._said(command, *arguments).splitlines()[-1])

    def _said(self, command: str, *arguments: str, seconds: float = 120) -> str:
        """Return what a command of the probe prints."""
        output = self.folder / f"{next(self._numbers)}-{command}.log"
        given = (command, *arguments)
        return ask(self.python, self.probe, self.env, given, output, seconds)

    def wait_for_endpoint(self, node: str, kind: str, name: str) -> dict[str, list[str]]:
        """Wait until a node has an endpoint, and return all that it has."""

        def look() -> dict[str, list[str]] | None:
            found = self.endpoints(node)
            return found if name in found[kind] else None

        return wait_until(look, f"{kind} {name} of {node}", 60)

    def _start(self, command: Sequence[str | Path], name: str) -> Process:
        log = self.folder / f"{next(self._numbers)}-{name}.log"
        process = Process(command, self.env, log)
        self.started.append(process)
        return process
