"""The services and actions, each with who provides it and who calls it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plastron_tui.ros.interfaces import InterfaceKind

from .entry import Entries
from .hubs import count_hubs, hub_entries

if TYPE_CHECKING:
    from ..analysis import Analysis


_INTERFACES = (InterfaceKind.SERVICE, InterfaceKind.ACTION)


def make(analysis: Analysis, _: object) -> Entries:
    """Make what the panel shows."""
    hubs = (hub for interface in _INTERFACES for hub in analysis.graph.at[interface])
    return Entries(hub_entries(hubs), "no services yet\nadder provides_service 'add' …")


def count(analysis: Analysis) -> int:
    """Return how much there is."""
    return sum(count_hubs(analysis, each) for each in _INTERFACES)
