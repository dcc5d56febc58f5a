"""What there is in the descriptions of robots, for those that a program changes in place."""

from __future__ import annotations

from collections.abc import Hashable, Iterator

from plastron_tui.ros.robots.facts import facts_of
from plastron_tui.sources.urdf.reader import read_urdf

from .robot_merges import merged_robot
from .text_layers import Form


def _parts(text: bytes) -> Iterator[Hashable] | None:
    found = read_urdf(text).description
    return None if found is None else facts_of(found)


def _names(text: bytes) -> set[Hashable]:
    found = _parts(text)
    return set() if found is None else set(found)


ROBOT_FORM = Form(_parts, _names, merged_robot)
