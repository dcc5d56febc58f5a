"""What a node does when it is played to: its endpoints, its messages, its answers, its logs."""

from __future__ import annotations

import json
import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import Any

from graph import Graph
from processes import own_tracebacks

KINDS = ("publishers", "subscriptions", "services")
# rospy itself warns of a connection that the player closed before it was of use.
LOG = re.compile(
    r"^\[(\w+)\] \[[\d.]+\](?: \[[\w./]+\])?: (?!Inbound TCP/IP connection failed)(.*)$",
    re.MULTILINE,
)

Fields = Mapping[str, Any]


@dataclass(frozen=True)
class Step:
    """A message that is sent, a service that is called, or a message that is waited for.

    The next step begins when one message more has come over each topic of `causes`.
    """

    kind: str
    name: str
    fields: Fields
    causes: tuple[str, ...] = ()
    answer: Fields = field(default_factory=dict)


def send(name: str, fields: Fields, *causes: str) -> Step:
    return Step("send", name, fields, causes)


def call(name: str, fields: Fields, *causes: str, answer: Fields | None = None) -> Step:
    """Call a service; `answer` is the response, where only the edited node has the service."""
    return Step("call", name, fields, causes, answer or {})


def wait(name: str, fields: Fields) -> Step:
    """Wait until the last message of a topic has these fields, among others."""
    return Step("wait", name, fields)


@dataclass(frozen=True)
class Traffic:
    """All that a node showed."""

    endpoints: Mapping[str, Mapping[str, Any]]
    heard: Mapping[str, list[Fields]]
    answers: list[Fields]
    logs: list[tuple[str, str]]


def record(
    graph: Graph,
    node: Path,
    steps: Sequence[Step],
    serves: Mapping[str, tuple[str, Fields]],
) -> Traffic:
    """Run a node, play the steps to it, and end it.

    Args:
        graph: where it runs.
        node: its file.
        steps: what is sent to it, what it is asked, and what is waited for.
        serves: services that the node may call: type and response.
    """
    process = graph.run_and_wait(node)
    [told] = re.findall("^endpoints: (.*)$", process.output, re.MULTILINE)
    endpoints = json.loads(told)
    play = json.dumps([endpoints, serves, [asdict(step) for step in steps]])
    player = graph.run_with(Path(__file__).with_name("player.py"), play)
    assert player.wait(120) == 0, player.output + process.output
    process.interrupt()
    assert not own_tracebacks(process.output), process.output
    played = json.loads(player.output.splitlines()[-1])
    return Traffic(endpoints, played["heard"], played["answers"], LOG.findall(process.output))


def without(steps: Sequence[Step], gone: Collection[str]) -> list[Step]:
    """Return the steps that are left where topics and services are gone."""
    return [
        replace(step, causes=tuple(each for each in step.causes if each not in gone))
        for step in steps
        if step.name not in gone
    ]


def renamed(steps: Sequence[Step], names: Mapping[str, str]) -> list[Step]:
    """Return the steps with other names of topics and services."""
    return [
        replace(
            step,
            name=names.get(step.name, step.name),
            causes=tuple(names.get(each, each) for each in step.causes),
        )
        for step in steps
    ]


def plain(message: Any) -> Any:
    """Return a message without what is of the run, or of one ROS only: clocks, and `seq`."""
    if isinstance(message, list):
        return [plain(each) for each in message]
    if not isinstance(message, dict):
        return message
    if message.keys() == {"sec", "nanosec"} and message["sec"] > 1e9:
        return "now"
    return {name: plain(value) for name, value in message.items() if name != "seq"}


def differences(
    before: Mapping[str, list[Fields]], after: Mapping[str, list[Fields]], steps: Sequence[Step]
) -> dict[str, tuple[list[Fields], list[Fields]]]:
    """Return what two nodes sent to each topic, where that is not the same.

    What no step causes is sent of the node's own accord, and heard from some message on, up to
    some message: there the same comes one after the other from the first on that both sent.
    """
    caused = {topic for step in steps for topic in step.causes}
    found = {topic: (plain(before[topic]), plain(after[topic])) for topic in before}
    return {
        topic: (one, other)
        for topic, (one, other) in found.items()
        if not (one == other if topic in caused else _overlap(changes(one), changes(other)))
    }


def _overlap(one: list[Any], other: list[Any]) -> bool:
    common = [message for message in one if message in other]
    if not common:
        return one == other
    one, other = (each[each.index(common[0]) :] for each in (one, other))
    return all(a == b for a, b in zip(one, other, strict=False))


def changes(messages: list[Any]) -> list[Any]:
    return [each for i, each in enumerate(messages) if i == 0 or each != messages[i - 1]]
