"""The plan of a whole node, from its parts."""

from __future__ import annotations

from collections.abc import Callable

from plastron_tui.model.kinds import (
    ActionClient,
    ActionServer,
    Client,
    Parameter,
    Publisher,
    Service,
    Subscription,
    Timer,
)
from plastron_tui.model.workspace import Node

from .actions import add_action_client, add_action_servers
from .parameters import add_parameters
from .plan import NodePlan
from .services import add_client, add_services
from .timers import add_timers
from .topics import add_publishers, add_subscriptions
from .writing import Writing


def _add_clients(writing: Writing, plan: NodePlan) -> None:
    """Plan what a node asks of others, in the order of the program."""
    node = writing.node
    clients: list[Client | ActionClient] = [*node.of(Client).values()]
    clients += node.of(ActionClient).values()
    for client in sorted(clients, key=lambda each: each.span.start if each.span else 0):
        if isinstance(client, Client):
            add_client(writing, plan, client)
        else:
            add_action_client(writing, plan, client)


_PARTS: tuple[Callable[[Writing, NodePlan], None], ...] = (
    add_parameters,
    add_publishers,
    add_subscriptions,
    add_services,
    add_action_servers,
    _add_clients,
    add_timers,
)
"""What plans each group of what a node has, in the order in which names are given."""


def plan_parts(writing: Writing, plan: NodePlan) -> None:
    """Plan all that a node has.

    Raises:
        CannotPlanError: its client library cannot have a part of it.
    """
    for add in _PARTS:
        add(writing, plan)


_LONGEST = 78
"""How long what a node does may be said, in characters: it has to go on one line."""


def summary(node: Node) -> str:
    """Return what a node does, as a sentence."""
    parts = [
        ("publishes messages", node.of(Publisher)),
        ("listens to messages", node.of(Subscription)),
        ("provides services", node.of(Service)),
        ("calls services", node.of(Client)),
        ("provides actions", node.of(ActionServer)),
        ("sends goals", node.of(ActionClient)),
        ("repeats functions", node.of(Timer)),
        ("has parameters", node.of(Parameter)),
    ]
    does = [text for text, has in parts if has] or ["does nothing yet"]
    said = len(does)
    text = _sentence(does)
    while len(text) > _LONGEST:
        said -= 1
        text = _sentence([*does[:said], "more"])
    return text


def _sentence(does: list[str]) -> str:
    text = does[0] if len(does) == 1 else f"{', '.join(does[:-1])} and {does[-1]}"
    return f"{text[0].upper()}{text[1:]}."
