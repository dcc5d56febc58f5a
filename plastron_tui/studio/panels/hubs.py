"""Topics, services and actions as entries, each with the nodes that meet there."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from plastron_tui.model.kinds import EndpointKind

from .endpoint_text import noted
from .entry import Entry
from .entry_signs import HUBS, SIGNS, type_text

if TYPE_CHECKING:
    from plastron_tui.model.graph import Hub
    from plastron_tui.model.workspace import Workspace
    from plastron_tui.ros.interfaces import InterfaceKind

    from ..analysis import Analysis


def hub_entries(hubs: Iterable[Hub]) -> Iterator[Entry]:
    """Yield the entries of what nodes meet at."""
    for hub in hubs:
        subject = HUBS[hub.interface]
        yield Entry(
            f"{subject.value} {hub.name}",
            hub.name,
            " or ".join(map(type_text, hub.types)),
            *SIGNS[subject],
            warning="" if hub.missing is None else f"nobody {hub.missing.facts.does}",
            span=next((end.span for end in hub.ends if end.span is not None), None),
            subject=subject,
            name=hub.name,
            is_branch=True,
        )
        for end in hub.ends:
            yield Entry(
                f"{end.kind.word} {end.node.variable} {end.written}",
                end.node.name,
                noted(end.kind.word, end.qos, is_guess=end.is_guess),
                *SIGNS[end.kind],
                depth=1,
                span=end.span,
                subject=end.kind,
                node=end.node.variable,
                name=end.written,
            )


def count_hubs(analysis: Analysis, interface: InterfaceKind) -> int:
    """Return how many topics, services or actions there are; the graph would take longer."""
    return analysis.once("hubs", lambda: _count(analysis.workspace))[interface]


def _count(workspace: Workspace) -> Counter[InterfaceKind]:
    from plastron_tui.ros.names import resolved_name

    interfaces = {kind: kind.facts.interface for kind in EndpointKind}
    names = {
        (interface, resolved_name(node.name, name))
        for node in workspace.nodes.values()
        for kind, endpoints in node.by_kind.items()
        if endpoints and (interface := interfaces[kind]) is not None
        for name in endpoints
    }
    return Counter([interface for interface, _ in names])
