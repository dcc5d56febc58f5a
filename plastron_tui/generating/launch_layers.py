"""What there is in launch files, for those that a program changes in place."""

from __future__ import annotations

from collections.abc import Hashable, Iterator

from plastron_tui.ros.launch import Argument, Include, Item, StartedNode, items_of, names_of
from plastron_tui.sources.launch.xml_reader import read_launch_xml

from .text_layers import Form

_NAMED = (Argument, StartedNode, Include)


def _parts(text: bytes) -> Iterator[Hashable] | None:
    launch = read_launch_xml(text).launch
    return None if launch is None else items_of(launch.items, Item)


def _names(text: bytes) -> set[Hashable]:
    launch = read_launch_xml(text).launch
    items = () if launch is None else launch.items
    return {(kind, name) for kind in _NAMED for name in names_of(items, kind)}


LAUNCH_FORM = Form(_parts, _names)
