"""What a program changed in a node that it loaded."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Iterator, Mapping

from plastron_tui.model.kinds import (
    EDITABLE,
    ActionServer,
    Endpoint,
    EndpointKind,
    Parameter,
    Publisher,
    Service,
    Subscription,
    callback_of,
    is_sending,
)
from plastron_tui.model.source import (
    Add,
    Change,
    Remove,
    Rename,
    SourceEndpoint,
    SourceUnit,
    Update,
)
from plastron_tui.model.workspace import Node
from plastron_tui.ros.interfaces import InterfaceName

_Manner = tuple[InterfaceName | None, str | None]
"""What tells endpoints of a kind apart besides their names: the type, and the callback."""


def changes_of(node: Node) -> tuple[Change, ...]:
    """Return what a program changed in a node that it loaded; what it renamed comes first."""
    if node.source is None:
        return ()
    renames = _renames(node, node.source)
    present = {
        kind: {name: name for name in names} for kind, names in names_in(node.source).items()
    }
    for each in renames:
        del present[each.kind][each.name]
    for each in renames:
        present[each.kind][each.to] = each.name
    changed = (
        change for kind in EDITABLE for change in _changes(node, node.source, kind, present[kind])
    )
    # Values of parameters are used by what else is new, and what is heard by what answers to it.
    heard = {
        sent.reaction.topic
        for publisher in node.of(Publisher).values()
        for sent in publisher.publications
        if sent.reaction is not None
    }
    return (*renames, *sorted(changed, key=lambda each: _turn(each, heard)))


def _turn(change: Change, heard: Collection[str]) -> int:
    """Return when a change is made; those of the same turn are made in their order."""
    if not isinstance(change, Add | Update):
        return 2
    match change.endpoint:
        case Parameter():
            return 0
        case Subscription(name=name) if name in heard:
            return 1
        case _:
            return 2


def _renames(node: Node, source: SourceUnit) -> list[Rename]:
    present = names_in(source)
    return [
        Rename(kind, old, new, span, source.label)
        for (kind, new), (old, span) in node.renamed.items()
        if old != new and old in present[kind]
    ]


def _changes(
    node: Node, source: SourceUnit, kind: EndpointKind, present: dict[str, str]
) -> Iterator[Change]:
    """Yield what differs of a kind; `present` has the file's names by what they are renamed to."""
    wanted = node.by_kind[kind]
    new = {name: each for name, each in wanted.items() if name not in present}
    gone: dict[str, list[SourceEndpoint]] = {name: [] for name in present if name not in wanted}
    if gone:
        names = {old: name for name, old in present.items()}
        for each in source.of_kind(kind):
            if (name := names.get(each.label or "")) in gone:
                gone[name].append(each)
    # What is of no type may be anything under another name.
    same = _same(gone, new) if gone and new and kind.facts.interface is not None else {}
    for name, endpoint in wanted.items():
        was = same.get(name, name)
        if endpoint.span is not None and was in present:
            yield Update(kind, was, endpoint, node.removed.get(was), source.label)
        elif endpoint.span is not None or is_sending(endpoint):
            yield Add(endpoint, source.label)
    # What is new goes beside what it replaces, in the same class.
    for name in sorted(gone.keys() - same.values()):
        yield Remove(kind, name, node.removed.get(name), source.label)


def _same(gone: Mapping[str, list[SourceEndpoint]], new: Mapping[str, Endpoint]) -> dict[str, str]:
    """Return which of the new endpoints is one of those that are gone, under another name.

    It is of the same type, and calls the same function, or no other one can be meant.
    """
    same: dict[str, str] = {}
    for has_callback in (True, False):
        olds: dict[_Manner, list[str]] = defaultdict(list)
        news: dict[_Manner, list[str]] = defaultdict(list)
        for name, found in gone.items():
            called = {(each.type, each.callback if has_callback else None) for each in found}
            if name not in same.values() and len(called) == 1:
                olds[called.pop()].append(name)
        for name, endpoint in new.items():
            if name not in same:
                callback = callback_of(endpoint) if has_callback else None
                news[endpoint.type, callback].append(name)
        for key, names in news.items():
            if len(names) == len(olds[key]) == 1 and (not has_callback or key[1] is not None):
                same[names[0]] = olds[key][0]
    return same


def names_in(source: SourceUnit) -> dict[EndpointKind, set[str]]:
    """Return the names that a file says, by kind."""
    names: dict[EndpointKind, set[str]] = {kind: set() for kind in EndpointKind}
    for endpoint in source.endpoints:
        if endpoint.label is not None:
            names[endpoint.kind].add(endpoint.label)
    return names


def call_again(node: Node, found: SourceEndpoint, name: str) -> None:
    """Let an endpoint of a node call the function that it calls in a file."""
    endpoint = node.endpoints.get((found.kind, name))
    if isinstance(endpoint, Subscription | Service | ActionServer):
        node.put(endpoint._replace(callback=found.callback))
