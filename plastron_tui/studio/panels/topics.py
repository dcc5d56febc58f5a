"""The topics, each with who speaks and who listens."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plastron_tui.ros.interfaces import InterfaceKind

from .entry import Entries
from .hubs import count_hubs, hub_entries

if TYPE_CHECKING:
    from ..analysis import Analysis


def make(analysis: Analysis, _: object) -> Entries:
    """Make what the panel shows."""
    found = hub_entries(analysis.graph.topics)
    return Entries(found, "no topics yet\ntalker publish … to 'chatter' …")


def count(analysis: Analysis) -> int:
    """Return how much there is."""
    return count_hubs(analysis, InterfaceKind.MESSAGE)
