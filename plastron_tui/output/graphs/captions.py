"""What the pictures of a graph say in words, so that all of them say the same."""

from __future__ import annotations

from collections.abc import Iterable

from plastron_tui.diagnostics.terminal import visible
from plastron_tui.model.graph import End, GraphNode, Hub, Sending
from plastron_tui.model.kinds import (
    ActionClient,
    Client,
    EndpointKind,
    Publisher,
    callback_of,
)
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.ros.qos_words import text_of


def missing_text(missing: EndpointKind | None) -> str:
    """Return `nobody listens` or the like, "" where nothing is missing."""
    return "" if missing is None else f"nobody {missing.facts.does}"


def type_text(types: tuple[InterfaceName, ...]) -> str:
    """Return the type, several with `or` between them, `type unknown` for none."""
    return " or ".join(visible(str(type_)) for type_ in types) or "type unknown"


def node_text(node: GraphNode) -> str:
    """Return the caption of a node: its library, or the file that it came from.

    The variable comes first where it is another than the name; alone it says what it is.
    """
    origin = node.file.name if node.file is not None else node.library
    managed = ["managed"] if node.is_managed else []
    if origin is None:
        parts = [] if node.variable == node.name else [f"variable {node.variable}"]
        return " · ".join([*parts, *managed])
    parts = [] if node.variable == node.name else [node.variable]
    return " · ".join([*parts, visible(origin), *managed])


def hub_text(hub: Hub) -> str:
    """Return the caption of a topic, service or action: its type, and its rate if there is one."""
    rates = {sending.pace for end in hub.tails for sending in end.sendings}
    rate = f" · {rates.pop()}" if len(rates) == 1 else ""
    return f"{type_text(hub.types)}{rate}"


def sendings_text(sendings: Iterable[Sending]) -> str:
    """Return what is sent and how often, "" for what a file sends."""
    return ", ".join(
        f"{sending.message} at {sending.pace}"
        if sending.rate
        else f"{sending.message} {sending.pace}"
        for sending in sendings
    )


def ends_of(hub: Hub) -> list[tuple[GraphNode, str, str]]:
    """Return who meets at a topic, service or action: the node, what it does, and the details."""
    return [(end.node, end.kind.facts.does, _with_guess(end)) for end in hub.ends]


def _with_guess(end: End) -> str:
    qos = "" if end.qos is None else text_of(end.qos)
    return ", ".join(filter(None, (_details(end), qos, "a guess" if end.is_guess else "")))


def _details(end: End) -> str:
    match end.endpoint:
        case Publisher():
            return sendings_text(end.sendings)
        case Client(requests=requests):
            if any(each.rate for each in requests):
                return ", ".join(f"at {each.rate}" if each.rate else "once" for each in requests)
            return "" if len(requests) < 2 else f"{len(requests)} times"
        case ActionClient(goals=goals):
            return "" if len(goals) < 2 else f"{len(goals)} times"
        case calling:
            return callback_of(calling) or ""
