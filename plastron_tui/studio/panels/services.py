"""The services, each with who provides it and who calls it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plastron_tui.ros.interfaces import InterfaceKind

from .entry import Entries, Subject
from .hubs import count_hubs, hub_entries
from .panel import Panel
from .program_panel import ProgramPanel

if TYPE_CHECKING:
    from ..analysis import Analysis


def _entries(analysis: Analysis, _: object) -> Entries:
    found = hub_entries(analysis.graph.services, Subject.SERVICE_NAME)
    return Entries(found, "no services yet\nadder provides_service 'add' …")


SERVICES = Panel(
    name="services",
    title="Services",
    dock="outline",
    keys="alt+3",
    summary="The services, each with who provides it and who calls.",
    about="Each service with who provides it ◆ and who calls it ◇. A ⚠ says which side is missing.",
    widget=ProgramPanel,
    make=_entries,
    count=lambda analysis: count_hubs(analysis.workspace, InterfaceKind.SERVICE),
)
