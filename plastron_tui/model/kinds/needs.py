"""What of a node needs another part of it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Span

from ..values import Computed, OfParameter, Value, computed_in
from . import ActionClient, Client, EndpointKind, Publisher, Service, Timer

if TYPE_CHECKING:
    from ..workspace import Node


def users_of(node: Node, kind: EndpointKind, name: str) -> list[Span]:
    """Return the statements that need what a node has of a kind and name.

    A topic that is subscribed to is needed by what is sent for each of its messages, a parameter
    by the values and the rates that are taken from it.
    """
    match kind:
        case EndpointKind.SUBSCRIPTION:
            found = [
                each.span
                for publisher in node.of(Publisher).values()
                for each in publisher.publications
                if each.reaction is not None and each.reaction.topic == name
            ]
        case EndpointKind.PARAMETER:
            parts = _parts(node)
            found = [span for span, value, rate in parts if rate == name or _has(value, name)]
        case _:
            found = []
    return [span for span in found if span is not None]


def rates_of(node: Node) -> set[str]:
    """Return the parameters of a node that say how often something is done."""
    return {rate for _, _, rate in _parts(node) if rate is not None}


def computed_of(node: Node, parameter: str) -> Iterator[Computed]:
    """Yield what a node computes of a parameter."""
    for _, value, _ in _parts(node):
        yield from _of(value, parameter)


def _parts(node: Node) -> list[tuple[Span | None, Value, str | None]]:
    """Return the statements of a node with their values, and the parameters of their rates."""
    found: list[tuple[Span | None, Value, str | None]] = []
    for publisher in node.of(Publisher).values():
        sent = publisher.publications
        found += [(each.span, each.message.value, each.parameter) for each in sent]
    for client in node.of(Client).values():
        found += [
            (client.span, each.value, each.rate.parameter if each.rate else None)
            for each in client.requests
        ]
    for action in node.of(ActionClient).values():
        found += [(action.span, goal, None) for goal in action.goals]
    for service in node.of(Service).values():
        found += [(service.span, service.answer or (), None)]
    for timer in node.of(Timer).values():
        found += [(timer.span, (), timer.rate.parameter if timer.rate else None)]
    return found


def _has(value: Value, parameter: str) -> bool:
    return any(True for _ in _of(value, parameter))


def _of(value: Value, parameter: str) -> Iterator[Computed]:
    source = OfParameter(parameter.removeprefix("~/"))
    return (each for each in computed_in(value) if each.source == source)
