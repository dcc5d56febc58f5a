"""The topics, each with who speaks and who listens."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plastron_tui.ros.interfaces import InterfaceKind

from .entry import Entries
from .hubs import count_hubs, hub_entries
from .panel import Panel
from .program_panel import ProgramPanel

if TYPE_CHECKING:
    from ..analysis import Analysis


def _entries(analysis: Analysis, _: object) -> Entries:
    found = hub_entries(analysis.graph.topics)
    return Entries(found, "no topics yet\ntalker publish … to 'chatter' …")


TOPICS = Panel(
    name="topics",
    title="Topics",
    dock="outline",
    keys="alt+2",
    summary="The topics, each with who publishes and who listens.",
    about="Each topic with who publishes ↑ and who listens ↓. A ⚠ says which side is missing.",
    widget=ProgramPanel,
    make=_entries,
    count=lambda analysis: count_hubs(analysis.workspace, InterfaceKind.MESSAGE),
)
