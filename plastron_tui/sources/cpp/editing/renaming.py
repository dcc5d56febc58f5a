"""Giving endpoints of a unit other names."""

from __future__ import annotations

from collections.abc import Sequence

from plastron_tui.model.source import Rename

from ..analysis import Analysis
from .plans import Plan
from .refusals import RefusedError


def plan_renames(analysis: Analysis, changes: Sequence[Rename]) -> Plan:
    """Plan renames, all at once.

    Raises:
        RefusedError: one cannot be made.
    """
    raise RefusedError("plastron cannot rename endpoints of C++ files yet", changes[0].span)
