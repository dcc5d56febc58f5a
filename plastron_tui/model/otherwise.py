"""What stops a robot, beside what drives it as long as a condition holds: the other side of it."""

from __future__ import annotations

from collections.abc import Sequence

from plastron_tui.ros.motion import is_command

from .kinds import Condition, Publication, Publisher
from .unconditional_motion import moves

_OPPOSITE = {("all", ">"): ("any", "<"), ("all", "<"): ("any", ">"),
             (None, ">"): (None, "<"), (None, "<"): (None, ">")}  # fmt: skip
"""Which condition is meant as the other side of one."""


def driven_while(publisher: Publisher, stops: Sequence[Publication]) -> Condition | None:
    """Return the condition whose failing stops a robot, None where messages are no such stop.

    `all received.ranges > 0.5` and `any received.ranges < 0.5` leave gaps: exactly 0.5, no range at
    all, and one that is no number. In none of them a robot may go on as it was told last, so the
    command to stop is sent whenever the one to move, of the same topics, is not.

    Args:
        publisher: what sends both.
        stops: what is sent under one condition.
    """
    first = stops[0].reaction
    if not is_command(str(publisher.type)) or first is None or first.condition is None:
        return None
    if any(moves(each.message.value) for each in stops):
        return None
    for each in publisher.publications:
        other = each.reaction
        if other is None or other.condition is None or other.topic != first.topic:
            continue
        is_near = first.condition == _other_side(other.condition)
        if is_near and other.condition.source.position is None and moves(each.message.value):
            return other.condition
    return None


def _other_side(condition: Condition) -> Condition | None:
    found = _OPPOSITE.get((condition.quantifier, condition.operator))
    return None if found is None else condition._replace(quantifier=found[0], operator=found[1])
