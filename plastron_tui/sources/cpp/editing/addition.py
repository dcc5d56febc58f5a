"""Adding an endpoint to a unit."""

from __future__ import annotations

from plastron_tui.model.source import Add
from plastron_tui.ros.catalog import Catalog

from ..analysis import Analysis
from .plans import Plan
from .refusals import RefusedError


def plan_addition(analysis: Analysis, change: Add, catalog: Catalog) -> Plan:
    """Plan a change.

    Raises:
        RefusedError: it cannot be made.
    """
    raise RefusedError("plastron cannot add endpoints to C++ files yet")
