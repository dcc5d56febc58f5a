"""Call sites of a file and endpoints of a program, as a merge compares and shows them."""

from __future__ import annotations

from plastron_tui.model.kinds import (
    EDITABLE,
    ActionClient,
    ActionServer,
    Client,
    Endpoint,
    EndpointKey,
    EndpointKind,
    Parameter,
    Publisher,
    Service,
    Subscription,
    Timer,
    callback_of,
)
from plastron_tui.model.source import SourceEndpoint, SourceUnit
from plastron_tui.model.values import computed_in
from plastron_tui.model.workspace import Node


def call_sites(source: SourceUnit) -> dict[EndpointKey, list[SourceEndpoint]]:
    """Return the call sites of a file.

    A name from a parameter counts by its default; a timer, which has none, by its callback.
    """
    found: dict[EndpointKey, list[SourceEndpoint]] = {}
    for endpoint in source.endpoints:
        name = endpoint.label if endpoint.label is not None else endpoint.default
        if name is not None and endpoint.kind in EDITABLE:
            found.setdefault((endpoint.kind, name), []).append(endpoint)
    return found


def is_shared(kind: EndpointKind) -> bool:
    """Tell whether others see what a node has of a kind: it has an interface."""
    return kind.facts.interface is not None


def has_type(found: SourceEndpoint, endpoint: Endpoint | None) -> bool:
    """Tell whether a call site may be of an endpoint's type: a type that is not known may be."""
    return found.type is None or (endpoint is not None and found.type == endpoint.type)


def with_callback(endpoint: Endpoint, name: str) -> Endpoint:
    """Return an endpoint that calls a function, where it is one that calls any."""
    match endpoint:
        case Subscription() | Service() | ActionServer():
            return endpoint._replace(callback=name)
        case _:
            return endpoint


def sends(endpoint: Endpoint) -> object:
    """Return what is sent through an endpoint, and when, to be compared."""
    match endpoint:
        case Publisher(publications=sent):
            return [
                (each.message.value, each.rate, each.parameter, each.is_once, each.reaction)
                for each in sent
            ]
        case Client(requests=sent):
            return list(sent)
        case ActionClient(goals=sent):
            return list(sent)
        case _:
            return None


_WORDS = {
    "publications": "messages",
    "requests": "calls",
    "goals": "goals",
    "answer": "answer",
    "qos": "quality of service",
    "rate": "rate",
    "holds": "type",
    "default": "default",
    "minimum": "range",
    "maximum": "range",
    "description": "description",
}
"""The fields of endpoints beside name, type, callback and place, and what they are called."""


def differing(one: Endpoint, other: Endpoint) -> list[str]:
    """Return what differs between two endpoints of a kind, but for names, types and callbacks."""
    words = [
        word
        for field, word in _WORDS.items()
        if field != "publications" and getattr(one, field, None) != getattr(other, field, None)
    ]
    sent = [_WORDS["publications"]] if isinstance(one, Publisher) else []
    return list(dict.fromkeys((*(sent if sends(one) != sends(other) else ()), *words)))


def is_changed(before: Endpoint, now: Endpoint) -> bool:
    """Tell whether a program asks for something else of an endpoint than before."""
    is_same = before.type == now.type and callback_of(before) == callback_of(now)
    return not is_same or bool(differing(before, now))


def is_plain(endpoint: Endpoint) -> bool:
    """Tell whether all of an endpoint is a call, its callback, and what is sent at fixed rates."""
    match endpoint:
        case Publisher(publications=sent, qos=None):
            return all(
                each.parameter is None
                and not each.is_once
                and each.reaction is None
                and not any(computed_in(each.message.value))
                for each in sent
            )
        case Client(requests=sent):
            return not any(each.rate or any(computed_in(each.value)) for each in sent)
        case Subscription(qos=None) | Service(answer=None):
            return True
        case _:
            return False


def asked(endpoint: Endpoint) -> object:
    """Return what a statement says of an endpoint besides, to be compared; None for nothing."""
    match endpoint:
        case Publisher(qos=qos) | Subscription(qos=qos):
            return qos
        case Timer(rate=rate):
            return rate
        case Parameter(default=default, minimum=minimum, maximum=maximum):
            return default, minimum, maximum
        case _:
            return None


def rates(endpoint: Endpoint) -> set[float]:
    """Return the rates that a publisher sends at, in hertz; a timer each."""
    sent = endpoint.publications if isinstance(endpoint, Publisher) else ()
    return {each.rate for each in sent if each.rate}


def count_timers(source: SourceUnit) -> int:
    """Count the timers that a file makes."""
    return sum(each.kind is EndpointKind.TIMER for each in source.endpoints)


def shown_name(key: EndpointKey) -> str:
    """Return kind and name, for a message."""
    return f"{key[0].word} `{key[1]}`"


def shown_lines(found: list[SourceEndpoint]) -> str:
    """Return the lines of call sites, for a message."""
    return " and ".join(str(each.line) for each in found)


def managed_changed(source: SourceUnit, base: Node | None, node: Node) -> str:
    """Say that a program alone changed whether a node is managed; "" where it did not.

    That changes more of a file than its endpoints.
    """
    is_there = any(each.is_managed for each in source.nodes)
    if base is None or node.is_managed in (base.is_managed, is_there):
        return ""
    return f"its node {'is managed now' if node.is_managed else 'is no longer managed'}"


def changed_in_program(key: EndpointKey, what: list[str]) -> str:
    """Say which details of an endpoint the program has changed, and the file has not."""
    verb = "is" if len(what) == 1 and not what[0].endswith("s") else "are"
    return f"the {' and '.join(what)} of the {shown_name(key)} {verb} changed in the program only"
