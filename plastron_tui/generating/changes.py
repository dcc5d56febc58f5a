"""What a program changed in a node that it loaded."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from plastron_tui.model.kinds import (
    EDITABLE,
    Client,
    Endpoint,
    EndpointKind,
    Publisher,
    Service,
    Subscription,
)
from plastron_tui.model.source import Add, Change, Remove, SourceEndpoint, SourceUnit
from plastron_tui.model.workspace import Node


def changes_of(node: Node) -> tuple[Change, ...]:
    """Return what a program changed in a node that it loaded."""
    if node.source is None:
        return ()
    return tuple(_changes(node, names_in(node.source), node.source.label))


def _changes(
    node: Node, present: Mapping[EndpointKind, set[str]], label: str | None
) -> Iterator[Change]:
    wanted = node.endpoints
    for kind in EDITABLE:
        for name in sorted(name for name in present[kind] if (kind, name) not in wanted):
            yield Remove(kind, name, node.removed.get(name), label)
        for key, endpoint in wanted.items():
            name = key[1]
            if key[0] is not kind:
                continue
            if endpoint.span is not None:
                # Removed and asked for again, with another type perhaps.
                if name in present[kind]:
                    yield Remove(kind, name, node.removed.get(name), label)
                yield Add(endpoint, label)
            elif is_extended(endpoint):
                yield Add(endpoint, label)


def is_extended(endpoint: Endpoint) -> bool:
    """Tell whether the program sends more through an endpoint that it found in the file."""
    match endpoint:
        case Publisher(publications=more) | Client(requests=more):
            return bool(more)
        case _:
            return False


def names_in(source: SourceUnit) -> dict[EndpointKind, set[str]]:
    """Return the names that a file says, by kind."""
    names: dict[EndpointKind, set[str]] = {kind: set() for kind in EndpointKind}
    for endpoint in source.endpoints:
        if endpoint.name is not None:
            names[endpoint.kind].add(endpoint.name)
    return names


def call_again(node: Node, found: SourceEndpoint, name: str) -> None:
    """Let an endpoint of a node call the function that it calls in a file."""
    endpoint = node.endpoints.get((found.kind, name))
    if isinstance(endpoint, Subscription | Service):
        node.put(endpoint._replace(callback=found.callback))
