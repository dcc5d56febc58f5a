"""What a program changed in a node that it loaded."""

from __future__ import annotations

from collections.abc import Iterator

from plastron_tui.model.kinds import (
    EDITABLE,
    Client,
    Endpoint,
    EndpointKind,
    Publisher,
    Service,
    Subscription,
)
from plastron_tui.model.source import Add, Change, Remove, SourceEndpoint, SourceUnit, Update
from plastron_tui.model.workspace import Node
from plastron_tui.ros.interfaces import InterfaceName


def changes_of(node: Node) -> tuple[Change, ...]:
    """Return what a program changed in a node that it loaded."""
    if node.source is None:
        return ()
    present = names_in(node.source)
    return tuple(
        change for kind in EDITABLE for change in _changes(node, node.source, kind, present[kind])
    )


def _changes(
    node: Node, source: SourceUnit, kind: EndpointKind, present: set[str]
) -> Iterator[Change]:
    wanted = node.by_kind[kind]
    gone = sorted(present - wanted.keys())
    new = [name for name in wanted if name not in present]
    earlier = {name: name for name in present}
    if len(gone) == len(new) == 1 and _types(source, kind, gone[0]) == {wanted[new[0]].type}:
        # Of the same type, it is the same endpoint under another name.
        earlier[new[0]] = gone.pop()
    for name in gone:
        yield Remove(kind, name, node.removed.get(name), source.label)
    for name, endpoint in wanted.items():
        if endpoint.span is not None and name in earlier:
            was = earlier[name]
            yield Update(kind, was, endpoint, node.removed.get(was), source.label)
        elif endpoint.span is not None or is_extended(endpoint):
            yield Add(endpoint, source.label)


def _types(source: SourceUnit, kind: EndpointKind, name: str) -> set[InterfaceName | None]:
    """Return the types that a file says of a name."""
    return {each.type for each in source.endpoints if (each.kind, each.name) == (kind, name)}


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
