"""Whether a robot that is to stop by what its sensors say is told to move whatever they say."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterator
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, Label, Span, codes
from plastron_tui.ros.motion import is_command
from plastron_tui.ros.names import resolved_name

from .kinds import Publication, Publisher
from .values import MessageValue
from .workspace import Node, Workspace


class _Sent(NamedTuple):
    node: Node
    publication: Publication
    span: Span


def check_motion(workspace: Workspace, version_of: Callable[[Node], int]) -> Iterator[Diagnostic]:
    """Yield a warning for each command to move that is sent at a rate beside conditional ones.

    A topic keeps no order of precedence: a robot does what it was told last. A message that stops
    it may be sent whatever arrives.

    Args:
        workspace: what a program without a mistake has built.
        version_of: tells the generation of ROS that a node is for.
    """
    always: dict[tuple[int, str], list[_Sent]] = defaultdict(list)
    conditional: dict[tuple[int, str], _Sent] = {}
    for node in workspace.nodes.values():
        for publisher in node.of(Publisher).values():
            # Of other types, two messages of one topic may both be meant.
            if not is_command(str(publisher.type)):
                continue
            place = version_of(node), resolved_name(node.name, publisher.name)
            for each in publisher.publications:
                if each.span is None:
                    continue
                sent = _Sent(node, each, each.span)
                if each.reaction is not None and each.reaction.condition is not None:
                    conditional.setdefault(place, sent)
                elif each.reaction is None and not each.is_once and moves(each.message.value):
                    always[place].append(sent)
    for place, several in always.items():
        if place in conditional:
            yield from (_warning(place[1], each, conditional[place]) for each in several)


def moves(value: MessageValue) -> bool:
    """Tell whether a command is more than one to stop; of a computed number that is not known."""
    return any(
        moves(each) if isinstance(each, MessageValue) else bool(each)
        for name, each in value.fields.items()
        if name != "header"
    )


def _warning(topic: str, always: _Sent, other: _Sent) -> Diagnostic:
    node, sent = always.node.variable, always.publication
    reaction = other.publication.reaction
    heard = "" if reaction is None else reaction.topic
    rate = f"`{sent.parameter}`" if sent.parameter is not None else f"{sent.rate:g} hz"
    return Diagnostic(
        codes.UNCONDITIONAL_MOTION,
        f"`{node}` sends `{sent.message.variable}` to `{topic.lstrip('/')}` at {rate}, whatever "
        f"`{heard}` says: the robot does not stop",
        always.span,
        help=f"take this line away, or send it `for_each '{heard}' when ...`",
        labels=(Label(other.span, f"sent only as `{heard}` says"),),
    )
