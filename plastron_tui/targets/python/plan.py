"""What the template of a Python node is given: names, literals and types, ready to be written.

Every string in a plan is Python source: a literal, an identifier, or an expression made of both.
The exceptions are the labels, which hold plain characters only.
"""

from __future__ import annotations

from dataclasses import dataclass, field


@dataclass(frozen=True, slots=True)
class PublisherPlan:
    """A publisher, and the attribute that holds it."""

    attribute: str
    topic: str
    type: str


@dataclass(frozen=True, slots=True)
class SendPlan:
    """A message that a timer sends; `is_stamped` when it has a header without a time."""

    message: str
    is_stamped: bool


@dataclass(frozen=True, slots=True)
class TimerPlan:
    """The messages that one publisher sends at one rate; `period` is in seconds."""

    publisher: str
    method: str
    period: str
    label: str
    sends: tuple[SendPlan, ...]


@dataclass(frozen=True, slots=True)
class SubscriptionPlan:
    """A subscription, and the method that it calls."""

    topic: str
    type: str
    callback: str


@dataclass(frozen=True, slots=True)
class ServicePlan:
    """A service, and the method that answers it."""

    name: str
    type: str
    handler: str


@dataclass(frozen=True, slots=True)
class MethodPlan:
    """A callback or a handler; `response` is a handler's default answer."""

    name: str
    label: str
    response: str = ""


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
    """

    name: str
    label: str
    class_name: str = ""
    summary: str = ""
    imports: str = ""
    publishers: list[PublisherPlan] = field(default_factory=list)
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
        others = self.publishers or self.subscriptions or self.services
        return bool(others) or not self.calls

    @property
    def ends(self) -> bool:
        """Whether the node ends after its calls, with a status that says how they went."""
        return not self.keeps_running
