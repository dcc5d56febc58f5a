"""What is known of nodes that run, fed by the reports of their monitor."""

from __future__ import annotations

import re
import time
from collections import deque
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple, TypeVar

from .live_parts import LiveEnd, LiveGoal, LiveParameter, ends_of, goal_of, parameter_of

MOST_SAMPLES = 60
"""So many of the latest numbers are kept of a topic, and of each field that is looked at."""
_MOST_NAMES = 5000
_MOST_GOALS = 100
NOT_WATCHED = "not watched any more"
SHOWN_GONE = 5.0
"""Seconds after which nobody wants to know of something that is gone, and not of the run."""
_ANONYMOUS = re.compile(r"(_\d+)+$")


class LiveField(NamedTuple):
    """A field of the last message: its path, and its value as text."""

    path: str
    text: str


@dataclass(slots=True)
class LiveTopic:
    """A topic of a running graph.

    Attributes:
        name: its full name.
        type: its type, such as `std_msgs/String`.
        publishers: how many publish to it.
        subscribers: how many listen.
        nodes: the nodes that publish or listen; nothing where nobody said.
        ends: the same, by what they do there.
        count: how many messages were seen while it was looked at.
        rate: messages a second.
        text: the last message in a line, "" before the first one.
        samples: the latest numbers of its messages, the last one last.
        fields: the fields of the last message, where they are looked at.
        field_samples: the latest numbers of each field, by its path.
        is_gone: whether it was there earlier in the run, and is no more.
    """

    name: str
    type: str
    publishers: int = 0
    subscribers: int = 0
    nodes: frozenset[str] = frozenset()
    ends: tuple[LiveEnd, ...] = ()
    count: int = 0
    rate: float = 0.0
    text: str = ""
    samples: deque[float] = field(default_factory=lambda: deque(maxlen=MOST_SAMPLES))
    fields: tuple[LiveField, ...] = ()
    field_samples: dict[str, deque[float]] = field(default_factory=dict)
    is_gone: bool = False

    def take(self, row: Mapping[str, Any]) -> None:
        """Take what a monitor says of it."""
        has_more = int(row["count"]) != self.count
        self.count, self.rate = int(row["count"]), float(row["rate"])
        self.text = str(row.get("text", self.text))
        number = row.get("number")
        if has_more and isinstance(number, (int, float)):
            self.samples.append(float(number))
        if "fields" not in row:
            self.fields = ()
            return
        self.fields = tuple(LiveField(str(path), str(text)) for path, text, _ in row["fields"])
        known = self.field_samples
        self.field_samples = {}
        for path, _, number in row["fields"]:
            if isinstance(number, (int, float)):
                samples = known.get(path) or deque(maxlen=MOST_SAMPLES)
                if has_more or not samples:
                    samples.append(float(number))
                self.field_samples[str(path)] = samples


class LiveService(NamedTuple):
    """A service, its type, who provides it, and whether it was there and is no more."""

    name: str
    type: str
    nodes: frozenset[str] = frozenset()
    is_gone: bool = False


class LiveAction(NamedTuple):
    """An action, as a service; `servers` says how many provide it: the others ask."""

    name: str
    type: str
    servers: int = 0
    nodes: frozenset[str] = frozenset()
    is_gone: bool = False


class LiveSending(NamedTuple):
    """A message that is sent from here again and again.

    Attributes:
        rate: how often a second; 0 where it is not sent any more.
        text: what is in it.
        problem: why it could not be sent, "" where it is.
    """

    rate: float
    text: str
    problem: str = ""


class NodeEnd(NamedTuple):
    """How a node has ended that nobody asked to.

    Attributes:
        how: in words.
        is_failure: whether that is a failure.
        said: the last line that it printed, "" for none.
    """

    how: str
    is_failure: bool
    said: str = ""


@dataclass(slots=True)
class LiveGraph:
    """The topics, services and nodes of one generation of ROS.

    Attributes:
        ros_version: the generation.
        topics: by name.
        services: by name.
        actions: by name.
        goals: those that were sent from here, by their numbers, the newest last.
        sendings: what is sent from here at a rate, by topic.
        nodes: by name, each with whether it is still there.
        parameters: those of the nodes that are looked at, by node.
        is_known: whether the monitor has said what there is.
        problem: what is wrong with the monitor, "" where nothing is.
        is_watched: whether a monitor says what is the case now; else all is what was seen last.
        has_ended: whether the nodes were ended, all of them.
        own: the nodes of the program in front, None where nobody said which.
        domain: the domain of ROS 2.
        ended: how nodes of the run have ended that nobody asked to, by their names.
        gone_since: when what is gone was missed first, by its key; by the clock of `monotonic`.
    """

    ros_version: int
    topics: dict[str, LiveTopic] = field(default_factory=dict)
    services: dict[str, LiveService] = field(default_factory=dict)
    actions: dict[str, LiveAction] = field(default_factory=dict)
    goals: dict[int, LiveGoal] = field(default_factory=dict)
    sendings: dict[str, LiveSending] = field(default_factory=dict)
    nodes: dict[str, bool] = field(default_factory=dict)
    parameters: dict[str, tuple[LiveParameter, ...]] = field(default_factory=dict)
    is_known: bool = False
    problem: str = ""
    is_watched: bool = True
    has_ended: bool = False
    own: frozenset[str] | None = None
    domain: str = "0"
    ended: dict[str, NodeEnd] = field(default_factory=dict)
    gone_since: dict[str, float] = field(default_factory=dict)
    _marked: set[str] = field(default_factory=set)

    @property
    def is_shown(self) -> bool:
        """Whether there is something to show: of nodes that ended only beside their program."""
        is_of_others = self.own is not None and not self.own
        return (self.is_known or bool(self.problem)) and not (self.has_ended and is_of_others)

    def feed(self, report: Mapping[str, Any]) -> bool:
        """Take a report; tell whether something is new. What is no report changes nothing."""
        try:
            match report.get("tell"):
                case "graph":
                    self._take_graph(report)
                case "topics":
                    for name, row in report["rows"].items():
                        if name in self.topics:
                            self.topics[name].take(row)
                case "parameters":
                    rows = tuple(parameter_of(row) for row in report["rows"])
                    self.parameters[str(report["node"])] = rows
                case "sending":
                    self._take_sending(report)
                case "goal":
                    goal = goal_of(report)
                    self.goals[goal.number] = goal
                    for number in list(self.goals)[:-_MOST_GOALS]:
                        del self.goals[number]
                case "problem":
                    self.problem = str(report["text"])
                case _:
                    return False
        except (KeyError, TypeError, ValueError, AttributeError, OverflowError):
            return False
        return True

    def _take_graph(self, report: Mapping[str, Any]) -> None:
        self.problem = ""
        self.is_known = self.is_watched = True
        found: dict[str, LiveTopic] = {}
        for name, type_, publishers, subscribers, *more in report["topics"][:_MOST_NAMES]:
            topic = self.topics.get(name)
            if topic is None or topic.type != type_:
                topic = LiveTopic(str(name), str(type_))
            topic.publishers, topic.subscribers = int(publishers), int(subscribers)
            topic.nodes, topic.ends = _names(more), ends_of(more)
            topic.is_gone = False
            found[topic.name] = topic
        for name, topic in self.topics.items():
            if name not in found and len(found) < _MOST_NAMES:
                topic.is_gone, topic.publishers, topic.subscribers = True, 0, 0
                topic.rate = 0.0
                found[name] = topic
        self.topics = dict(sorted(found.items()))
        services = [LiveService(str(name), str(type_), _names(nodes))
                    for name, type_, *nodes in report["services"]]  # fmt: skip
        actions = [LiveAction(str(name), str(type_), int(servers), frozenset(map(str, nodes)))
                   for name, type_, servers, nodes in report.get("actions", ())]  # fmt: skip
        self.services = _with_gone(self.services, services)
        self.actions = _with_gone(self.actions, actions)
        there = set(map(str, report["nodes"]))
        for name in there:
            if self.nodes.get(name) is False:
                # Somebody has started it again.
                self.ended.pop(name, None)
        self.nodes = {name: name in there for name in sorted({*self.nodes, *there})[:_MOST_NAMES]}
        gone = {
            *(f"topic {name}" for name, each in self.topics.items() if each.is_gone),
            *(f"service {name}" for name, each in self.services.items() if each.is_gone),
            *(f"action {name}" for name, each in self.actions.items() if each.is_gone),
            *(f"node {name}" for name, is_there in self.nodes.items() if not is_there),
        }
        now = time.monotonic()
        self.gone_since = {key: self.gone_since.get(key, now) for key in sorted(gone)}

    def is_past(self, key: str, nodes: Iterable[str], now: float) -> bool:
        """Tell whether something is gone for so long that it matters only where it is of the run.

        Args:
            key: what it is, such as `topic /chatter`.
            nodes: the nodes that have it, or had it.
            now: the time by the clock of `monotonic`.
        """
        since = self.gone_since.get(key)
        return since is not None and now - since >= SHOWN_GONE and not self.is_own(nodes)

    def _take_sending(self, report: Mapping[str, Any]) -> None:
        name, rate = str(report["name"]), float(report["rate"])
        problem = str(report.get("problem", ""))
        if rate > 0 or problem:
            self.sendings[name] = LiveSending(rate, str(report["text"]), problem)
        else:
            self.sendings.pop(name, None)

    def lose_monitor(self) -> None:
        """Note that the monitor is no more: all is what was seen last."""
        self.is_watched = False
        self.drop_orders()

    def drop_orders(self) -> None:
        """Note that who was told to send something has ended: it sends no more."""
        self.sendings.clear()
        for number, goal in self.goals.items():
            if not goal.is_over:
                self.goals[number] = goal._replace(state=NOT_WATCHED, is_over=True)

    def is_own(self, nodes: Iterable[str]) -> bool:
        """Tell whether one of some nodes is of the program; all are where nobody said which."""
        named = frozenset(nodes)
        own = self.own
        if own is None or not named:
            return True
        # A node of ROS 1 may ask for a number behind its name ("anonymous").
        is_numbered = self.ros_version == 1
        return any(
            node in own or (is_numbered and _ANONYMOUS.sub("", node) in own) for node in named
        )

    def mark_ended(self, names: Iterable[str], end: NodeEnd) -> bool:
        """Note how nodes have ended; tell whether that is new.

        One that was too quick to be seen was there all the same.
        """
        new = [name for name in names if name not in self._marked]
        self._marked.update(new)
        numbered = {_ANONYMOUS.sub("", name) for name in self.nodes if self.ros_version == 1}
        unseen = (name for name in new if name not in self.nodes and name not in numbered)
        self.nodes.update(dict.fromkeys(unseen, False))
        self.ended.update(dict.fromkeys(new, end))
        return bool(new)

    def forget_ends(self, names: Iterable[str]) -> None:
        """Note that nodes start again."""
        for name in names:
            self._marked.discard(name)
            self.ended.pop(name, None)

    def end(self) -> None:
        """Note that the nodes have ended: all is what was seen last."""
        self.has_ended = True


_Named = TypeVar("_Named", LiveService, LiveAction)


def _with_gone(before: Mapping[str, _Named], now: Iterable[_Named]) -> dict[str, _Named]:
    """Return what is there now, and what was there before and is marked as gone."""
    gone = {name: each._replace(is_gone=True) for name, each in before.items()}
    there = {each.name: each for each in now}
    return dict(sorted({**gone, **there}.items())[:_MOST_NAMES])


def _names(nodes: Sequence[Iterable[object]]) -> frozenset[str]:
    """Return the names of nodes, the first list of a report, if it has one."""
    return frozenset(map(str, nodes[0])) if nodes else frozenset()
