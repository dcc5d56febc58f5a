"""The endpoints of a node, created or loaded, and the messages that go through them."""

from __future__ import annotations

from enum import Enum
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Span
from plastron_tui.ros.interfaces import InterfaceName

if TYPE_CHECKING:
    from .values import MessageValue

DEFAULT_RATE = 10.0
"""How often a message is published where the program does not say, in hertz."""


class EndpointKind(str, Enum):
    """What a call site creates. The values are the keys of `plastron inspect --format json`."""

    PUBLISHER = "publishers"
    SUBSCRIPTION = "subscriptions"
    SERVICE = "services"
    CLIENT = "clients"
    ACTION_SERVER = "action_servers"
    ACTION_CLIENT = "action_clients"
    TIMER = "timers"
    PARAMETER = "parameters"

    @property
    def word(self) -> str:
        """What one of the kind is called, such as `action server`."""
        return self.value.replace("_", " ").removesuffix("s")


EDITABLE = (
    EndpointKind.PUBLISHER,
    EndpointKind.SUBSCRIPTION,
    EndpointKind.SERVICE,
    EndpointKind.CLIENT,
)
"""The kinds of endpoints that statements add and remove."""


class Message(NamedTuple):
    """A message that a program created, under its variable's name."""

    variable: str
    value: MessageValue
    span: Span


class Publication(NamedTuple):
    """One message on its way to a topic, and how often it is sent, in hertz.

    `is_rate_open` tells that the program leaves the rate to Plastron, or to the loop of a file
    that has one; `rate` is then the default.
    """

    message: Message
    rate: float
    span: Span | None = None
    is_rate_open: bool = False


class Publisher(NamedTuple):
    """A topic that a node publishes; `publications` is empty for one that was read from a file."""

    topic: str
    type: InterfaceName | None
    publications: tuple[Publication, ...] = ()
    span: Span | None = None


class Subscription(NamedTuple):
    """A topic that a node listens to; without a `callback` the target names one."""

    topic: str
    type: InterfaceName | None
    callback: str | None = None
    span: Span | None = None


class Service(NamedTuple):
    """A service that a node provides; without a `handler` the target names one."""

    name: str
    type: InterfaceName | None
    handler: str | None = None
    span: Span | None = None


class Client(NamedTuple):
    """A service that a node calls, with the request of each call, in order."""

    name: str
    type: InterfaceName | None
    requests: tuple[MessageValue, ...] = ()
    span: Span | None = None


Endpoint = Publisher | Subscription | Service | Client
EndpointKey = tuple[EndpointKind, str]
"""What an endpoint is known by: its kind, and its graph name as it is written."""
