"""What the template of a node is given: names, literals and types, ready to be written.

Every string in a plan is source code of the node's language: a literal, an identifier, or code made
of both. The exceptions are the labels, which hold plain characters only.
"""

from __future__ import annotations

from collections.abc import Iterable
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

    `is_stamped` when it has a header without a time; `unsure` is what it is computed of that may
    not be there, or fit no field.
    """

    message: str
    is_stamped: bool
    unsure: tuple[str, ...] = ()


def _unsure(sends: Iterable[SendPlan], *others: str) -> str:
    """Name what may not be there, or fit no field, of messages and besides; "" for nothing."""
    return ", ".join(dict.fromkeys((*others, *(name for each in sends for name in each.unsure))))


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
        is_function: whether the method is a function of the program's own.
    """

    method: str
    period: str
    label: str = ""
    publisher: str = ""
    sends: tuple[SendPlan, ...] = ()
    attribute: str = ""
    parameter: str = ""
    rate: str = ""
    is_function: bool = False

    @property
    def unsure(self) -> str:
        """What is computed that may fit no field, "" for nothing."""
        return _unsure(self.sends)


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
    def unsure(self) -> str:
        """What is computed that may fit no field, "" for nothing."""
        return _unsure(self.sends)


class ReactionPlan(NamedTuple):
    """The messages that a publisher sends for those of a topic, called `received`.

    `type` is the class of `received`. `condition` is "" where they are sent for each, `compared`
    what of it may not be there. `is_heard` tells whether anything depends on what is received.
    """

    publisher: str
    method: str
    topic: str
    type: str
    heard: str
    label: str
    sends: tuple[SendPlan, ...]
    condition: str
    compared: tuple[str, ...] = ()
    is_heard: bool = True

    @property
    def unsure(self) -> str:
        """What is computed or compared that may not be there, or fit no field, "" for nothing."""
        return _unsure(self.sends, *self.compared)


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
        type: the type of its value, "" in a language that needs none.
        is_own: whether it is one of the node, and not of the whole ROS 1.
    """

    name: str
    label: str
    default: str
    attribute: str
    getter: str
    descriptor: str
    check: str
    wanted: str
    type: str = ""
    is_own: bool = False


@dataclass(frozen=True, slots=True)
class SubscriptionPlan:
    """A subscription, and the method that it calls.

    `qos` is what says what it asks for, `attribute` what holds it, "" where nothing does.
    """

    topic: str
    type: str
    callback: str
    qos: str
    attribute: str = ""


@dataclass(frozen=True, slots=True)
class ServicePlan:
    """A service, the method that answers it, and the attribute that holds it, "" for none."""

    name: str
    type: str
    handler: str
    attribute: str = ""


@dataclass(slots=True)
class MethodPlan:
    """A callback or a handler.

    Attributes:
        name: what it is called.
        label: the topic or the service, as prose.
        type: the class of what it is called with.
        response: what a handler answers.
        answer: what the program says that it answers, "" where it says nothing.
        unsure: what is computed in the answer that may not be there, or fit no field, "" for
            nothing.
        reactions: the methods that a callback hands its message to.
    """

    name: str
    label: str
    type: str
    response: str = ""
    answer: str = ""
    unsure: str = ""
    reactions: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class ClientPlan:
    """A client of a service or of an action, and the attribute that holds it."""

    attribute: str
    name: str
    type: str


class WorkPlan(NamedTuple):
    """Requests to a service, or goals of an action, that a node sends one after the other.

    Attributes:
        method: what sends them.
        client: the attribute of the client.
        name: the service or the action, as a literal.
        label: the service or the action, as prose.
        sends: what makes each request or goal, when it is sent.
        is_goals: whether they are goals.
        repeat: what a timer calls to send them again, "" where they are sent once.
        task: the attribute that holds the last sending of those, "" where nothing does.
    """

    method: str
    client: str
    name: str
    label: str
    sends: tuple[str, ...]
    is_goals: bool = False
    repeat: str = ""
    task: str = ""


class ActionServerPlan(NamedTuple):
    """An action that a node provides.

    Attributes:
        attribute: what holds the server (ROS 1), or the goal that is worked on (ROS 2).
        server: what holds the server of a managed node, "" in others.
        name: the action, as a literal.
        label: the action, as prose.
        type: the class of the action.
        method: what works on a goal.
        feedback: what makes a feedback.
        result: what makes a result.
    """

    attribute: str
    name: str
    label: str
    type: str
    method: str
    feedback: str
    result: str
    server: str = ""


@dataclass(slots=True)
class NodePlan:
    """A whole node.

    Attributes:
        name: the node's name, as a literal.
        label: the node's name, as prose.
        class_name: the name of its class.
        summary: what it does, a sentence.
        imports: the lines of its imports.
        is_managed: whether it is a lifecycle node: an attribute holds whatever its transitions
            make.
        functions: the functions of the file that it calls, of those that Plastron has.
    """

    name: str
    label: str
    class_name: str = ""
    summary: str = ""
    imports: str = ""
    is_managed: bool = False
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
    action_servers: list[ActionServerPlan] = field(default_factory=list)
    action_clients: list[ClientPlan] = field(default_factory=list)
    works: list[WorkPlan] = field(default_factory=list)

    @property
    def following(self) -> list[TimerPlan]:
        """The timers whose rates are those of parameters."""
        return [each for each in self.timers if each.parameter]

    @property
    def endpoint_attributes(self) -> list[str]:
        """What holds the endpoints of a managed node, which is there from its configuration on."""
        return [
            *(each.attribute for each in self.publishers),
            *(each.attribute for each in self.clients),
            *self.action_attributes,
            *(each.attribute for each in self.services),
            *(each.attribute for each in self.subscriptions),
        ]

    @property
    def action_attributes(self) -> list[str]:
        """What holds the clients and servers of actions of a managed node."""
        clients = [each.attribute for each in self.action_clients]
        return [*clients, *(each.server for each in self.action_servers)]

    @property
    def timer_attributes(self) -> list[str]:
        """What holds the timers of a managed node, which are there while it is active."""
        return [*(each.attribute for each in self.timers), *(each.timer for each in self.once)]

    @property
    def is_made(self) -> bool:
        """Whether the transitions of a managed node make anything."""
        return bool(self.endpoint_attributes or self.timer_attributes)

    @property
    def calls(self) -> list[WorkPlan]:
        """The calls of services."""
        return [each for each in self.works if not each.is_goals]

    @property
    def goals(self) -> list[WorkPlan]:
        """The goals that are sent."""
        return [each for each in self.works if each.is_goals]

    @property
    def tasks(self) -> list[WorkPlan]:
        """The calls and the goals that are sent once, in the program's order."""
        return [each for each in self.works if not each.repeat]

    @property
    def warns(self) -> bool:
        """Whether the node warns while nobody serves what it waits for: who ends gives up calls."""
        return bool(self.goals) or (bool(self.calls) and self.keeps_running)

    @property
    def waits(self) -> bool:
        """Whether the node waits, for others or for a next step, while it goes on with the rest."""
        return bool(self.works or self.action_servers)

    @property
    def keeps_running(self) -> bool:
        """Whether the node has anything to do after its calls and goals, or does them again."""
        others = (
            self.publishers
            or self.subscriptions
            or self.services
            or self.action_servers
            or self.timers
            or self.is_managed
        )
        return bool(others) or not self.tasks

    @property
    def ends(self) -> bool:
        """Whether the node ends after its calls and goals, and says by its status how they went."""
        return not self.keeps_running
