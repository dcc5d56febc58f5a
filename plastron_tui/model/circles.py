"""Messages that go round: what is sent for each message of a topic leads back to that topic."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterator

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.ros.names import resolved_name

from .kinds import Publisher
from .workspace import Node, Workspace

_Topic = tuple[int, str]
"""A topic in a generation of ROS, by its full name."""


def check_circles(workspace: Workspace, version_of: Callable[[Node], int]) -> Iterator[Diagnostic]:
    """Yield a warning for each statement that closes a circle of messages.

    One with a condition in it is meant to end.

    Args:
        workspace: what a program built.
        version_of: tells the generation of ROS that a node is for.
    """
    sent_for: dict[_Topic, list[_Topic]] = defaultdict(list)
    reached: set[_Topic] = set()
    for span, heard, sent in sorted(_reactions(workspace, version_of)):
        reached.add(sent)
        if heard in reached and heard in _reached(sent, sent_for):
            back = "itself" if heard == sent else f"`{heard[1]}`"
            yield Diagnostic(
                codes.ENDLESS_MESSAGES,
                f"`{sent[1]}` leads back to {back}, so that one message is sent for ever",
                span,
                help="send to another topic, or say `when` it is sent",
            )
        else:
            sent_for[heard].append(sent)


def _reactions(
    workspace: Workspace, version_of: Callable[[Node], int]
) -> Iterator[tuple[Span, _Topic, _Topic]]:
    """Yield what is sent without a condition: the statement, the topic heard, the one sent to."""
    for node in workspace.nodes.values():
        version = version_of(node)
        for publisher in node.of(Publisher).values():
            for each in publisher.publications:
                if each.reaction is None or each.reaction.condition is not None or not each.span:
                    continue
                heard, sent = (
                    (version, resolved_name(node.name, name))
                    for name in (each.reaction.topic, publisher.name)
                )
                yield each.span, heard, sent


def _reached(start: _Topic, sent_for: dict[_Topic, list[_Topic]]) -> set[_Topic]:
    """Return the topics that a message of one leads to, itself among them."""
    found, new = {start}, [start]
    while new:
        ahead = {topic for each in new for topic in sent_for.get(each, ())}
        new = list(ahead - found)
        found |= ahead
    return found
