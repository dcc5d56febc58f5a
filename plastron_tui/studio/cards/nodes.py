"""What is said about nodes, and about the topics, services and actions at which they meet."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from plastron_tui.model.graph import KINDS_AT, NOUNS
from plastron_tui.model.kinds import Endpoint, EndpointKind, Publisher, Subscription
from plastron_tui.model.kinds.publisher import Publication
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.ros.names import resolved_name
from plastron_tui.ros.qos_words import text_of

from ..editor.card import CardRow
from ..panels.endpoint_text import endpoint_text
from .known import Known

if TYPE_CHECKING:
    from plastron_tui.model.workspace import Node

_BETWEEN = " · "


def node_rows(node: Node, known: Known) -> Iterator[CardRow]:
    """Yield where a node comes from, and all that it does."""
    if node.variable != node.name:
        yield CardRow("in the program", node.variable)
    if node.source is not None:
        yield CardRow("file", node.source.path.name)
    else:
        yield CardRow("library", known.library_of(node))
    if node.home is not None and not node.home.is_own:
        yield CardRow("package", node.home.package, f"started by {node.home.executable}")
    if node.is_managed:
        yield CardRow("managed", "it waits until somebody activates it")
    if node.is_idle:
        yield CardRow("it does nothing yet", is_warning=True)
    guesses = node.guesses
    for kind, endpoints in node.by_kind.items():
        for name, endpoint in endpoints.items():
            said = endpoint_text(endpoint, is_guess=(kind, name) in guesses)
            note = _BETWEEN.join(_paces(endpoint))
            yield CardRow(kind.facts.does or kind.word, f"{kind.written(name)}  {said}", note)


def _paces(endpoint: Endpoint) -> list[str]:
    """Return how often a publisher sends, as far as the program says it."""
    sent = endpoint.publications if isinstance(endpoint, Publisher) else ()
    return list(dict.fromkeys(map(_pace, sent)))


def _pace(publication: Publication) -> str:
    if publication.reaction is not None:
        return f"for each {publication.reaction.topic}"
    if publication.is_once:
        return "once"
    if publication.parameter is not None:
        return f"as often as the parameter {publication.parameter} says"
    return f"{publication.rate:g} times a second"


def hub_name(written: str, node: Node | None) -> str:
    """Return the full name of a topic or service as a node has it."""
    return resolved_name("" if node is None else node.name, written)


def hub_rows(name: str, interface: InterfaceKind, known: Known) -> Iterator[CardRow]:
    """Yield the types of a topic or service, and who meets there; which side is missing is said."""
    ends = list(ends_at(name, interface, known))
    types = dict.fromkeys(str(end.type) for _, _, end in ends if end.type is not None)
    if types:
        yield CardRow("type", " or ".join(types), is_warning=len(types) > 1)
    for node, kind, end in ends:
        qos = end.qos if isinstance(end, Publisher | Subscription) else None
        is_guess = (kind, end.name) in node.guesses
        parts = [
            *_paces(end),
            text_of(qos) if qos is not None else "",
            "a guess" if is_guess else "",
        ]
        source = "" if node.source is None else f"({node.source.path.name})"
        text = " ".join(filter(None, (node.name, source)))
        yield CardRow(kind.facts.does, text, _BETWEEN.join(filter(None, parts)))
    sides = {kind.facts.sends for _, kind, _ in ends}
    for kind in KINDS_AT[interface]:
        if kind.facts.sends not in sides:
            yield CardRow(f"nobody {kind.facts.does}", is_warning=True)
            sides.add(kind.facts.sends)


def ends_at(
    name: str, interface: InterfaceKind, known: Known
) -> Iterator[tuple[Node, EndpointKind, Endpoint]]:
    """Yield who meets at a full name, in the order of the kinds of endpoints."""
    for kind in KINDS_AT[interface]:
        for node in known.workspace.nodes.values():
            for written, endpoint in node.by_kind[kind].items():
                if resolved_name(node.name, written) == name:
                    yield node, kind, endpoint


def noun(interface: InterfaceKind) -> str:
    """Return what nodes meet at: a `topic`, a `service`, an `action`."""
    return NOUNS[interface]
