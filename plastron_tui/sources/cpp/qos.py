"""The quality of service of a topic."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plastron_tui.ros.qos import Qos

if TYPE_CHECKING:
    from .analysis import Analysis
    from .sites import Found


def qos_of(analysis: Analysis, found: Found) -> Qos | None:
    """Return what a call says of it, None for nothing."""
    del analysis, found
    return None
