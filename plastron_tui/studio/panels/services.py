"""The services and actions, each with who provides it and who calls it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plastron_tui.ros.interfaces import InterfaceKind

from .entry import Entries
from .hubs import count_hubs, hub_entries
from .panel import Panel
from .program_panel import ProgramPanel

if TYPE_CHECKING:
    from ..analysis import Analysis


_INTERFACES = (InterfaceKind.SERVICE, InterfaceKind.ACTION)


def _entries(analysis: Analysis, _: object) -> Entries:
    hubs = (hub for interface in _INTERFACES for hub in analysis.graph.at[interface])
    return Entries(hub_entries(hubs), "no services yet\nadder provides_service 'add' …")


SERVICES = Panel(
    name="services",
    title="Services",
    dock="outline",
    keys="alt+3",
    summary="The services and actions, each with who provides it and who calls.",
    about=(
        "Each service with who provides it ◆ and who calls it ◇, and each action with who does the "
        "task ★ and who wants it done ☆. A ⚠ says which side is missing."
    ),
    widget=ProgramPanel,
    make=_entries,
    count=lambda analysis: sum(count_hubs(analysis.workspace, each) for each in _INTERFACES),
)
