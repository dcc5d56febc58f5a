"""The nodes, each with its endpoints."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain
from typing import TYPE_CHECKING, NamedTuple

from .endpoint_text import endpoint_text
from .entry import Entries, Entry, Subject
from .entry_signs import SIGNS

if TYPE_CHECKING:
    from plastron_tui.model.workspace import Node, Workspace

    from ..analysis import Analysis


class _Known(NamedTuple):
    """The entries of a node, and what they were made of."""

    node: Node
    library: str | None
    entries: tuple[Entry, ...]


def make(analysis: Analysis, _: object) -> Entries:
    """Make what the panel shows."""
    workspace = analysis.workspace
    libraries = _libraries(workspace, analysis.session.library)
    now: dict[str, _Known] = {}
    before = analysis.memo.swap("nodes", now) or {}
    for variable, node in workspace.nodes.items():
        library, known = libraries[variable], before.get(variable)
        # After an edit the nodes above it are the same objects.
        if known is None or known.node is not node or known.library != library:
            known = _Known(node, library, tuple(_node(variable, node, library)))
        now[variable] = known
    entries = chain.from_iterable([known.entries for known in now.values()])
    return Entries(entries, "no nodes yet\ncreate_node 'talker' as talker")


def _libraries(workspace: Workspace, default: str) -> dict[str, str | None]:
    """Return the client library of each node by its variable; None where only its file says it."""
    generated = {made.node.variable: made.library for made in workspace.generations}
    return {
        variable: node.library
        or generated.get(variable)
        or (default if node.source is None else None)
        for variable, node in workspace.nodes.items()
    }


def _node(variable: str, node: Node, library: str | None) -> Iterator[Entry]:
    from_file = node.source.path.name if node.source is not None else None
    parts = [part for part in (from_file or library, node.is_managed and "managed") if part]
    if variable != node.name:
        parts.insert(0, variable)
    yield Entry(
        f"node {variable}",
        node.name,
        " · ".join(parts),
        *SIGNS[Subject.NODE],
        warning="does nothing" if node.is_idle else "",
        span=node.span,
        subject=Subject.NODE,
        node=variable,
        name=variable,
        is_branch=not node.is_idle,
    )
    yield from _endpoints(variable, node)


def _endpoints(variable: str, node: Node) -> Iterator[Entry]:
    guesses = node.guesses
    for kind, endpoints in node.by_kind.items():
        if not endpoints:
            continue
        word, (sign, tone) = kind.word, SIGNS[kind]
        for written, endpoint in endpoints.items():
            is_guess = (kind, written) in guesses
            name = kind.written(written)
            # In order and not by name: there may be thousands, and all are made at every key.
            yield Entry(
                f"{word} {variable} {name}",
                name,
                endpoint_text(endpoint, is_guess=is_guess),
                sign,
                tone,
                "",
                1,
                endpoint.span,
                kind,
                variable,
                name,
            )


def count(analysis: Analysis) -> int:
    """Return how much there is."""
    return len(analysis.workspace.nodes)
