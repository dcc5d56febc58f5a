"""The kinds of endpoints, each declared once: here, and in a file of its own.

What is generic about endpoints (agreement of types, panels, graphs, what is remembered of a
node, the statements that end them) follows from an entry. A kind without `editing` is read in
files and shown, and no statement makes one.
"""

from __future__ import annotations

from enum import Enum
from typing import TypeVar

from plastron_tui.diagnostics import codes
from plastron_tui.language import statements as st
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.ros.names import check_parameter_name, check_service_name

from .client import Client, request
from .facts import INTERFACES, Editing, Facts
from .publisher import (
    DEFAULT_RATE,
    HIGHEST_RATE,
    LOWEST_RATE,
    Message,
    Publication,
    Publisher,
    publish,
)
from .service import Service, provide
from .subscription import Subscription, subscribe

__all__ = [
    "DEFAULT_RATE",
    "EDITABLE",
    "HIGHEST_RATE",
    "INTERFACES",
    "LOWEST_RATE",
    "Client",
    "Editing",
    "Endpoint",
    "EndpointKey",
    "EndpointKind",
    "EndpointType",
    "Facts",
    "Message",
    "Publication",
    "Publisher",
    "Service",
    "Subscription",
    "callback_of",
    "is_sending",
    "kind_of",
]

Endpoint = Publisher | Subscription | Service | Client
EndpointType = TypeVar("EndpointType", Publisher, Subscription, Service, Client)


class EndpointKind(str, Enum):
    """What a call site creates. The values are the keys of `plastron inspect --format json`."""

    facts: Facts

    def __new__(cls, key: str, facts: Facts) -> EndpointKind:
        """Make a kind: its key, and what holds for all its endpoints."""
        made = str.__new__(cls, key)
        made._value_ = key
        made.facts = facts
        return made

    PUBLISHER = (
        "publishers",
        Facts(
            verb="publishes to",
            role="publisher",
            does="publishes",
            named="topic",
            interface=InterfaceKind.MESSAGE,
            sends=True,
            sign="↑",
            tone="success",
            editing=Editing(
                endpoint=Publisher,
                made_by=st.Publish,
                make=publish,
                ended_by=st.StopPublishing,
                not_there=codes.NOT_PUBLISHING,
                infinitive="publish to",
            ),
        ),
    )
    SUBSCRIPTION = (
        "subscriptions",
        Facts(
            verb="subscribes to",
            role="subscriber",
            does="listens",
            named="topic",
            interface=InterfaceKind.MESSAGE,
            calls_back=True,
            sign="↓",
            tone="accent",
            editing=Editing(
                endpoint=Subscription,
                made_by=st.Subscribe,
                make=subscribe,
                ended_by=st.Unsubscribe,
                not_there=codes.NOT_SUBSCRIBED,
                infinitive="subscribe to",
            ),
        ),
    )
    SERVICE = (
        "services",
        Facts(
            verb="provides the service",
            role="provider",
            does="provides",
            named="service",
            check_name=check_service_name,
            interface=InterfaceKind.SERVICE,
            calls_back=True,
            sign="◆",
            tone="warning",
            editing=Editing(
                endpoint=Service,
                made_by=st.ProvidesService,
                make=provide,
                ended_by=st.StopService,
                not_there=codes.NOT_PROVIDING,
                infinitive="provide",
            ),
        ),
    )
    CLIENT = (
        "clients",
        Facts(
            verb="requests the service",
            role="client",
            does="calls",
            named="service",
            check_name=check_service_name,
            interface=InterfaceKind.SERVICE,
            sends=True,
            sign="◇",
            tone="secondary",
            editing=Editing(
                endpoint=Client,
                made_by=st.ClientRequests,
                make=request,
                ended_by=st.StopRequest,
                not_there=codes.NOT_REQUESTING,
                infinitive="request",
            ),
        ),
    )
    ACTION_SERVER = (
        "action_servers",
        Facts(
            verb="serves the action",
            role="action server",
            does="serves",
            named="action",
            interface=InterfaceKind.ACTION,
            calls_back=True,
        ),
    )
    ACTION_CLIENT = (
        "action_clients",
        Facts(
            verb="requests the action",
            role="action client",
            does="calls",
            named="action",
            interface=InterfaceKind.ACTION,
            sends=True,
        ),
    )
    TIMER = "timers", Facts(verb="has a timer of", named=None, interface=None, calls_back=True)
    PARAMETER = (
        "parameters",
        Facts(
            verb="uses the parameter",
            named="name",
            check_name=check_parameter_name,
            interface=None,
        ),
    )

    @property
    def word(self) -> str:
        """What one of the kind is called, such as `action server`."""
        return str(self.value).replace("_", " ").removesuffix("s")

    @property
    def editing(self) -> Editing:
        """How statements make and end one, of a kind in `EDITABLE`."""
        assert self.facts.editing is not None
        return self.facts.editing


EndpointKey = tuple[EndpointKind, str]
"""What an endpoint is known by: its kind, and its graph name as it is written."""

EDITABLE = tuple(kind for kind in EndpointKind if kind.facts.editing is not None)
"""The kinds of endpoints that statements make and end."""

_KINDS = {kind.editing.endpoint: kind for kind in EDITABLE}


def kind_of(endpoint: type[Endpoint]) -> EndpointKind:
    """Return the kind that a class of endpoints is of."""
    return _KINDS[endpoint]


def is_sending(endpoint: Endpoint) -> bool:
    """Tell whether the program sends something through an endpoint."""
    match endpoint:
        case Publisher(publications=sent) | Client(requests=sent):
            return bool(sent)
        case _:
            return False


def callback_of(endpoint: Endpoint) -> str | None:
    """Return the function that an endpoint calls, None where the target names one, or none is."""
    match endpoint:
        case Subscription(callback=name) | Service(callback=name):
            return name
        case _:
            return None
