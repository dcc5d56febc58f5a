"""Changing an endpoint of a unit where it stands."""

from __future__ import annotations

from plastron_tui.model.source import Update
from plastron_tui.ros.catalog import Catalog

from ..analysis import Analysis
from .plans import Plan


class NotInPlaceError(Exception):
    """An endpoint that has to be taken out and written anew."""


def plan_update(analysis: Analysis, change: Update, catalog: Catalog) -> Plan:
    """Plan a change.

    Raises:
        NotInPlaceError: it is to be made apart.
        RefusedError: it cannot be made.
    """
    raise NotInPlaceError
