"""Call sites of a file and endpoints of a program, as a merge compares and shows them."""

from __future__ import annotations

from plastron_tui.model.kinds import (
    EDITABLE,
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
)
from plastron_tui.model.source import SourceEndpoint, SourceUnit


def call_sites(source: SourceUnit) -> dict[EndpointKey, list[SourceEndpoint]]:
    """Return the call sites of a file; a name from a parameter counts by its default."""
    found: dict[EndpointKey, list[SourceEndpoint]] = {}
    for endpoint in source.endpoints:
        name = endpoint.label if endpoint.label is not None else endpoint.default
        if name is not None and endpoint.kind in EDITABLE:
            found.setdefault((endpoint.kind, name), []).append(endpoint)
    return found


def has_type(found: SourceEndpoint, endpoint: Endpoint) -> bool:
    """Tell whether a call site may be of an endpoint's type: a type that is not known may be."""
    return found.type is None or found.type == endpoint.type


def with_callback(endpoint: Endpoint, name: str) -> Endpoint:
    """Return an endpoint that calls a function, where it is one that calls any."""
    match endpoint:
        case Subscription() | Service() | ActionServer():
            return endpoint._replace(callback=name)
        case _:
            return endpoint


def sends(endpoint: Endpoint) -> object:
    """Return what is sent through an endpoint, and how often, to be compared."""
    match endpoint:
        case Publisher(publications=sent):
            return [(each.rate, each.message.value) for each in sent]
        case Client(requests=sent):
            return list(sent)
        case _:
            return None


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
    return {x.rate for x in endpoint.publications} if isinstance(endpoint, Publisher) else set()


def count_timers(source: SourceUnit) -> int:
    """Count the timers that a file makes."""
    return sum(each.kind is EndpointKind.TIMER for each in source.endpoints)


def shown_name(key: EndpointKey) -> str:
    """Return kind and name, for a message."""
    return f"{key[0].word} `{key[1]}`"


def shown_lines(found: list[SourceEndpoint]) -> str:
    """Return the lines of call sites, for a message."""
    return " and ".join(str(each.line) for each in found)
