"""What of a running graph is looked at: nothing else is listened to."""

from __future__ import annotations

from collections.abc import Sequence, Set
from typing import NamedTuple

from .live_row import Kind, LiveRow


class Watching(NamedTuple):
    """What is looked at, of one generation of ROS.

    Attributes:
        topics: the topics in sight.
        full: those of them whose fields are in sight, and the one that the cursor is on: what is
            sent to that begins with them.
        nodes: the nodes that are unfolded: their parameters may be in sight any moment.
    """

    topics: tuple[str, ...] = ()
    full: tuple[str, ...] = ()
    nodes: tuple[str, ...] = ()


def watching_of(
    rows: Sequence[LiveRow],
    in_sight: range,
    version: int,
    unfolded: Set[str],
    cursor: LiveRow | None = None,
) -> Watching:
    """Return what is looked at of one generation of ROS.

    Args:
        rows: the panel's rows, of all generations.
        in_sight: the places of those that can be seen.
        version: the generation.
        unfolded: the keys of the rows that are unfolded.
        cursor: the row that the cursor is on.
    """
    full_keys = unfolded if cursor is None else {*unfolded, cursor.key}
    own = [row for row in rows if row.ros_version == version]
    seen = [row for row in rows[in_sight.start : in_sight.stop] if row.ros_version == version]
    topics = dict.fromkeys(row.owner for row in seen if row.kind in (Kind.TOPIC, Kind.FIELD))
    full = [name for name in topics if f"{version} topic {name}" in full_keys]
    nodes = [row.owner for row in own if row.kind is Kind.NODE and row.is_open]
    return Watching(tuple(topics), tuple(full), tuple(nodes))
