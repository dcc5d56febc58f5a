"""The kinds of endpoints, each declared once: here, and in a file of its own.

What is generic about endpoints (agreement of types, panels, graphs, what is remembered of a
node, the statements that end them) follows from an entry. A kind without `editing` is read in
files and shown, and no statement makes one.
"""

from __future__ import annotations

from enum import Enum
from typing import TypeAlias, TypeVar

from plastron_tui.diagnostics import codes
from plastron_tui.language import statements as st
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.ros.names import check_parameter_name, check_service_name

from .action_client import ActionClient, send_goal
from .action_server import ActionServer, provide_action
from .client import Client, Request, request
from .facts import INTERFACES, Editing, Facts
from .parameter import Parameter, has_parameter
from .publisher import (
    DEFAULT_RATE,
    Message,
    Publication,
    Publisher,
    publish,
)
from .rate import HIGHEST_RATE, LOWEST_RATE, Rate
from .reaction import Condition, Reaction
from .service import Service, provide
from .subscription import Subscription, subscribe
from .timer import Timer, repeat

__all__ = [
    "DEFAULT_RATE",
    "EDITABLE",
    "HIGHEST_RATE",
    "INTERFACES",
    "LOWEST_RATE",
    "MADE_BY",
    "ActionClient",
    "ActionServer",
    "Client",
    "Condition",
    "Editing",
    "Endpoint",
    "EndpointKey",
    "EndpointKind",
    "EndpointType",
    "Facts",
    "Message",
    "Parameter",
    "Publication",
    "Publisher",
    "Rate",
    "Reaction",
    "Request",
    "Service",
    "Subscription",
    "Timer",
    "callback_of",
    "is_sending",
    "kind_of",
]

Endpoint: TypeAlias = (
    Publisher | Subscription | Service | Client | ActionServer | ActionClient | Timer | Parameter
)
EndpointType = TypeVar(
    "EndpointType",
    Publisher,
    Subscription,
    Service,
    Client,
    ActionServer,
    ActionClient,
    Timer,
    Parameter,
)


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
                already=codes.ALREADY_SUBSCRIBED,
                indicative="subscribes to",
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
                already=codes.ALREADY_PROVIDING,
                indicative="provides",
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
            check_name=check_service_name,
            interface=InterfaceKind.ACTION,
            calls_back=True,
            sign="★",
            tone="warning",
            editing=Editing(
                endpoint=ActionServer,
                made_by=st.ProvidesAction,
                make=provide_action,
                ended_by=st.StopAction,
                not_there=codes.NOT_SERVING,
                infinitive="provide the action",
                already=codes.ALREADY_SERVING,
                indicative="provides the action",
            ),
        ),
    )
    ACTION_CLIENT = (
        "action_clients",
        Facts(
            verb="requests the action",
            role="action client",
            does="calls",
            named="action",
            check_name=check_service_name,
            interface=InterfaceKind.ACTION,
            sends=True,
            sign="☆",
            tone="secondary",
            editing=Editing(
                endpoint=ActionClient,
                made_by=st.SendsGoal,
                make=send_goal,
                ended_by=st.StopGoal,
                not_there=codes.NOT_SENDING,
                infinitive="send goals to",
            ),
        ),
    )
    TIMER = (
        "timers",
        Facts(
            verb="repeats",
            named=None,
            interface=None,
            calls_back=True,
            sign="↻",
            tone="secondary",
            editing=Editing(
                endpoint=Timer,
                made_by=st.Repeats,
                make=repeat,
                ended_by=st.StopRepeating,
                not_there=codes.NOT_REPEATING,
                infinitive="repeat",
                already=codes.ALREADY_REPEATING,
                indicative="repeats",
            ),
        ),
    )
    PARAMETER = (
        "parameters",
        Facts(
            verb="uses the parameter",
            named="name",
            check_name=check_parameter_name,
            interface=None,
            sign="=",
            tone="accent",
            editing=Editing(
                endpoint=Parameter,
                made_by=st.HasParameter,
                make=has_parameter,
                ended_by=st.NoLongerHasParameter,
                not_there=codes.NOT_HAVING,
                infinitive="have the parameter",
                already=codes.ALREADY_HAVING,
                indicative="has the parameter",
            ),
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

    def written(self, name: str) -> str:
        """Return how programs write the name of one: a private parameter's without the sign."""
        return name.removeprefix("~/") if self is EndpointKind.PARAMETER else name


EndpointKey = tuple[EndpointKind, str]
"""What an endpoint is known by: its kind, and its graph name as it is written."""

EDITABLE = tuple(kind for kind in EndpointKind if kind.facts.editing is not None)
"""The kinds of endpoints that statements make and end."""

MADE_BY = {kind.editing.made_by: kind for kind in EDITABLE}
"""The kind that each statement makes one of."""

_KINDS = {kind.editing.endpoint: kind for kind in EDITABLE}


def kind_of(endpoint: type[Endpoint]) -> EndpointKind:
    """Return the kind that a class of endpoints is of."""
    return _KINDS[endpoint]


def is_sending(endpoint: Endpoint) -> bool:
    """Tell whether the program sends something through an endpoint."""
    match endpoint:
        case Publisher(publications=sent) | Client(requests=sent) | ActionClient(goals=sent):
            return bool(sent)
        case _:
            return False


def callback_of(endpoint: Endpoint) -> str | None:
    """Return the function that an endpoint calls, None where the target names one, or none is."""
    match endpoint:
        case Subscription(callback=name) | Service(callback=name) | ActionServer(callback=name):
            return name
        case Timer(name=name):
            return name
        case _:
            return None
