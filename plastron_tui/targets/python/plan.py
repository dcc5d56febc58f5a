"""What the template of a Python node is given: names, literals and types, ready to be written.

Every string in a plan is Python source: a literal, an identifier, or an expression made of both.
The exceptions are the labels, which hold plain characters only.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple


@dataclass(frozen=True, slots=True)
class PublisherPlan:
    """A publisher, and the attribute that holds it; `qos` is what says how messages are kept."""

    attribute: str
    topic: str
    type: str
    qos: str


@dataclass(frozen=True, slots=True)
class SendPlan:
    """A message that is sent.

    `is_stamped` when it has a header without a time; `may_fail` when it is computed of what may
    not be there.
    """

    message: str
    is_stamped: bool
    may_fail: bool = False


class TimerPlan(NamedTuple):
    """What a node does at a rate: it sends messages, or calls a function of its own.

    Attributes:
        method: what is called.
        period: the seconds between two calls.
        label: the topic, or the function, as prose.
        publisher: what the messages are sent through, "" where there are none.
        sends: the messages.
        attribute: what holds the timer, "" where nothing needs it.
        parameter: the name of the parameter that says the rate, as a literal, "" where none does.
        rate: what reads that parameter.
    """

    method: str
    period: str
    label: str = ""
    publisher: str = ""
    sends: tuple[SendPlan, ...] = ()
    attribute: str = ""
    parameter: str = ""
    rate: str = ""

    @property
    def may_fail(self) -> bool:
        """Whether what is computed may fit no field."""
        return any(each.may_fail for each in self.sends)


class OncePlan(NamedTuple):
    """The messages that a publisher sends once, and what waits until somebody listens."""

    publisher: str
    method: str
    timer: str
    label: str
    sends: tuple[SendPlan, ...]
    heard: str = ""
    waiting: str = ""

    @property
    def may_fail(self) -> bool:
        """Whether what is computed may fit no field."""
        return any(each.may_fail for each in self.sends)


class ReactionPlan(NamedTuple):
    """The messages that a publisher sends for those of a topic, called `received`.

    `condition` is "" where they are sent for each.
    """

    publisher: str
    method: str
    topic: str
    heard: str
    label: str
    sends: tuple[SendPlan, ...]
    condition: str
    is_condition_sure: bool = True

    @property
    def may_fail(self) -> bool:
        """Whether what is computed or compared may not be there, or fit no field."""
        return not self.is_condition_sure or any(each.may_fail for each in self.sends)


class ParameterPlan(NamedTuple):
    """A parameter.

    Attributes:
        name: its name, as a literal.
        label: its name, as prose.
        default: the value where none is set.
        attribute: what holds the last good value (ROS 1).
        getter: the method that reads it (ROS 1).
        descriptor: what describes it (ROS 2), "" for nothing.
        check: what holds of a `value` that is one of it (ROS 1).
        wanted: what a value is to be, in words.
    """

    name: str
    label: str
    default: str
    attribute: str
    getter: str
    descriptor: str
    check: str
    wanted: str


@dataclass(frozen=True, slots=True)
class SubscriptionPlan:
    """A subscription, and the method that it calls; `qos` is what says what it asks for."""

    topic: str
    type: str
    callback: str
    qos: str


@dataclass(frozen=True, slots=True)
class ServicePlan:
    """A service, and the method that answers it."""

    name: str
    type: str
    handler: str


@dataclass(slots=True)
class MethodPlan:
    """A callback or a handler.

    Attributes:
        name: what it is called.
        label: the topic or the service, as prose.
        response: what a handler answers.
        answer: what the program says that it answers, "" where it says nothing.
        may_fail: whether what is computed in the answer may not be there, or fit no field.
        reactions: the methods that a callback hands its message to.
    """

    name: str
    label: str
    response: str = ""
    answer: str = ""
    may_fail: bool = False
    reactions: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class ClientPlan:
    """A client, and the attribute that holds it."""

    attribute: str
    name: str
    type: str


@dataclass(frozen=True, slots=True)
class CallPlan:
    """One call of a service."""

    client: str
    request: str


@dataclass(slots=True)
class NodePlan:
    """A whole node.

    Attributes:
        name: the node's name, as a literal.
        label: the node's name, as prose.
        class_name: the name of its class.
        summary: what it does, a sentence.
        imports: the lines of its imports.
        functions: the functions of the file that it calls, of those that Plastron has.
    """

    name: str
    label: str
    class_name: str = ""
    summary: str = ""
    imports: str = ""
    functions: frozenset[str] = frozenset()
    parameters: list[ParameterPlan] = field(default_factory=list)
    publishers: list[PublisherPlan] = field(default_factory=list)
    once: list[OncePlan] = field(default_factory=list)
    reactions: list[ReactionPlan] = field(default_factory=list)
    timers: list[TimerPlan] = field(default_factory=list)
    subscriptions: list[SubscriptionPlan] = field(default_factory=list)
    callbacks: list[MethodPlan] = field(default_factory=list)
    services: list[ServicePlan] = field(default_factory=list)
    handlers: list[MethodPlan] = field(default_factory=list)
    clients: list[ClientPlan] = field(default_factory=list)
    calls: list[CallPlan] = field(default_factory=list)

    @property
    def keeps_running(self) -> bool:
        """Whether the node has anything to do after its calls."""
        others = self.publishers or self.subscriptions or self.services or self.timers
        return bool(others or self.parameters) or not self.calls

    @property
    def following(self) -> list[TimerPlan]:
        """The timers whose rates are those of parameters."""
        return [each for each in self.timers if each.parameter]

    @property
    def ends(self) -> bool:
        """Whether the node ends after its calls, with a status that says how they went."""
        return not self.keeps_running
