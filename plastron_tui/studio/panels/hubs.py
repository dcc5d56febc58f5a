"""Topics and services as entries, each with the nodes that meet there."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from .entry import SIGNS, Entry, Subject, type_text

if TYPE_CHECKING:
    from plastron_tui.model.graph import Hub
    from plastron_tui.model.workspace import Workspace
    from plastron_tui.ros.interfaces import InterfaceKind


def hub_entries(hubs: Iterable[Hub], subject: Subject) -> Iterator[Entry]:
    """Yield the entries of topics, or of services."""
    for hub in hubs:
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
                end.kind.word + (" (a guess)" if end.is_guess else ""),
                *SIGNS[end.kind],
                depth=1,
                span=end.span,
                subject=end.kind,
                node=end.node.variable,
                name=end.written,
            )


def count_hubs(workspace: Workspace, interface: InterfaceKind) -> int:
    """Return how many topics, or services, there are; the graph would take longer."""
    from plastron_tui.ros.names import resolved_name

    return len({
        resolved_name(node.name, name)
        for node in workspace.nodes.values()
        for kind, endpoints in node.by_kind.items()
        if kind.facts.interface is interface
        for name in endpoints
    })  # fmt: skip
