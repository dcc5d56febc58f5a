"""The rows of the live panel that say who is at a topic, and what a node does."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from plastron_tui.diagnostics.terminal import visible
from plastron_tui.runtime.live_graph import LiveAction, LiveGraph, LiveService, LiveTopic

from .live_row import Kind, LiveRow, one_line

_MOST = 8
"""So many nodes are named at a topic."""


def end_rows(key: str, topic: LiveTopic, version: int) -> Iterator[LiveRow]:
    """Yield who publishes to a topic, and who listens.

    Args:
        key: the key of the topic's row.
        topic: what is known of it.
        version: the generation of ROS.
    """
    for number, end in enumerate(topic.ends[:_MOST]):
        qos = f"  {visible(end.qos)}" if end.qos else ""
        words = f"{'from' if end.sends else 'to'} {visible(end.node)}{qos}"
        yield _note(f"{key} end {number}", words, topic.name, version)
    more = len(topic.ends) - _MOST
    if more > 0:
        yield _note(f"{key} ends", f"and {more} more", topic.name, version)


def doing_rows(key: str, node: str, graph: LiveGraph) -> Iterator[LiveRow]:
    """Yield what a node sends, hears and offers.

    Args:
        key: the key of the node's row.
        node: its full name.
        graph: what is known of all.
    """
    ends = [
        (end.sends, each.name)
        for each in graph.topics.values()
        for end in each.ends
        if end.node == node and not each.is_gone
    ]
    doing = {
        "sends": [name for sends, name in ends if sends],
        "hears": [name for sends, name in ends if not sends],
        "offers": _having(node, graph.services.values()),
        "action": _having(node, graph.actions.values()),
    }
    for verb, names in doing.items():
        if names:
            words = one_line(f"{verb} {', '.join(dict.fromkeys(names))}")
            yield _note(f"{key} {verb}", words, node, graph.ros_version)


def _having(node: str, known: Iterable[LiveService | LiveAction]) -> list[str]:
    return [each.name for each in known if node in each.nodes and not each.is_gone]


def _note(key: str, words: str, owner: str, version: int) -> LiveRow:
    return LiveRow(key, Kind.NOTE, words, owner, version, depth=1, tone="quiet")
