"""Taking an endpoint out of a unit."""

from __future__ import annotations

from plastron_tui.model.source import Remove

from ..analysis import Analysis
from .plans import Plan
from .refusals import RefusedError


def plan_removal(analysis: Analysis, change: Remove) -> Plan:
    """Plan a change.

    Raises:
        RefusedError: it cannot be made.
    """
    raise RefusedError("plastron cannot take endpoints out of C++ files yet")
