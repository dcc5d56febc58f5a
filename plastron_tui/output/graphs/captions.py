"""What the pictures of a graph say in words, so that all of them say the same."""

from __future__ import annotations

from collections.abc import Iterable

from plastron_tui.diagnostics.terminal import visible
from plastron_tui.model.graph import (
    GraphNode,
    GraphService,
    GraphTopic,
    Missing,
    Sending,
    ServiceClient,
    ServiceProvider,
    TopicPublisher,
    TopicSubscriber,
)
from plastron_tui.ros.interfaces import InterfaceName

_MISSING = {
    Missing.PUBLISHER: "nobody publishes",
    Missing.SUBSCRIBER: "nobody listens",
    Missing.PROVIDER: "nobody provides",
    Missing.CLIENT: "nobody calls",
}


def missing_text(missing: Missing | None) -> str:
    """Return `nobody listens` or the like, "" where nothing is missing."""
    return "" if missing is None else _MISSING[missing]


def type_text(types: tuple[InterfaceName, ...]) -> str:
    """Return the type, several with `or` between them, `type unknown` for none."""
    return " or ".join(visible(str(type_)) for type_ in types) or "type unknown"


def node_text(node: GraphNode) -> str:
    """Return the caption of a node: its library, or the file that it came from.

    The variable comes first where it is another than the name; alone it says what it is.
    """
    origin = node.file.name if node.file is not None else node.library
    if origin is None:
        return "" if node.variable == node.name else f"variable {node.variable}"
    parts = [] if node.variable == node.name else [node.variable]
    return " · ".join([*parts, visible(origin)])


def topic_text(topic: GraphTopic) -> str:
    """Return the caption of a topic: its type, and how often it is published where that is one."""
    rates = {sending.rate for publisher in topic.publishers for sending in publisher.sendings}
    rate = f" · {hertz(rates.pop())}" if len(rates) == 1 else ""
    return f"{type_text(topic.types)}{rate}"


def hertz(rate: float) -> str:
    """Return a rate with its unit."""
    return f"{rate:g} Hz"


def sendings_text(sendings: Iterable[Sending]) -> str:
    """Return what is sent and how often, "" for what a file sends."""
    return ", ".join(f"{sending.message} at {hertz(sending.rate)}" for sending in sendings)


def ends_of(
    place: GraphTopic | GraphService,
) -> list[tuple[GraphNode, str, str]]:
    """Return who meets at a topic or service: the node, what it does, and the details."""
    ends: list[_End]
    if isinstance(place, GraphTopic):
        ends = [*place.publishers, *place.subscribers]
    else:
        ends = [*place.providers, *place.clients]
    return [(end.node, *_part(end)) for end in ends]


_End = TopicPublisher | TopicSubscriber | ServiceProvider | ServiceClient


def _part(end: _End) -> tuple[str, str]:
    match end:
        case TopicPublisher():
            return "publishes", sendings_text(end.sendings)
        case TopicSubscriber():
            return "listens", end.callback or ""
        case ServiceProvider():
            return "provides", end.handler or ""
        case ServiceClient():
            count = len(end.requests)
            return "calls", "" if count < 2 else f"{count} times"
