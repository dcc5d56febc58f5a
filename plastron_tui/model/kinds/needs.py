"""What of a node needs another part of it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Span

from ..values import Computed, MessageValue, OfParameter, Value, computed_in, with_source
from . import (
    ActionClient,
    Client,
    Endpoint,
    EndpointKind,
    Publisher,
    Rate,
    Request,
    Service,
    Timer,
)

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


def rename_uses(node: Node, kind: EndpointKind, old: str, new: str) -> None:
    """Let what needs a part of a node need it by its new name."""
    for endpoint in list(node.endpoints.values()):
        match kind:
            case EndpointKind.SUBSCRIPTION:
                now = _of_topic(endpoint, old, new)
            case EndpointKind.PARAMETER:
                now = _of_parameter(endpoint, old, new)
            case _:
                return
        if now is not endpoint:
            node.put(now)


def _of_topic(endpoint: Endpoint, old: str, new: str) -> Endpoint:
    if not isinstance(endpoint, Publisher):
        return endpoint
    sent = tuple(
        each._replace(reaction=each.reaction._replace(topic=new))
        if each.reaction is not None and each.reaction.topic == old
        else each
        for each in endpoint.publications
    )
    return endpoint if sent == endpoint.publications else endpoint._replace(publications=sent)


def _of_parameter(endpoint: Endpoint, old: str, new: str) -> Endpoint:
    def message(value: MessageValue) -> MessageValue:
        before, after = (OfParameter(each.removeprefix("~/")) for each in (old, new))
        found = with_source(value, before, after)
        assert isinstance(found, MessageValue)
        return found

    def rate(given: Rate | None) -> Rate | None:
        is_meant = given is not None and given.parameter == old
        return given._replace(parameter=new) if given is not None and is_meant else given

    match endpoint:
        case Publisher(publications=sent):
            now: Endpoint = endpoint._replace(
                publications=tuple(
                    each._replace(
                        message=each.message._replace(value=message(each.message.value)),
                        parameter=new if each.parameter == old else each.parameter,
                    )
                    for each in sent
                )
            )
        case Client(requests=sent):
            now = endpoint._replace(
                requests=tuple(Request(message(each.value), rate(each.rate)) for each in sent)
            )
        case ActionClient(goals=sent):
            now = endpoint._replace(goals=tuple(map(message, sent)))
        case Service(answer=answer) if answer is not None:
            now = endpoint._replace(answer=message(answer))
        case Timer():
            now = endpoint._replace(rate=rate(endpoint.rate))
        case _:
            return endpoint
    return endpoint if now == endpoint else now


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
    return (each for each in computed_in(value) if source in each.origins)
