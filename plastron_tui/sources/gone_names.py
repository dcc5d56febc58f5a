"""The names that changes take out of files, whatever language these are in."""

from __future__ import annotations

from plastron_tui.diagnostics import Span
from plastron_tui.model.source import Change, Remove, Rename, Update


def gone_name(change: Change) -> tuple[str | None, Span | None]:
    """Return the name that a change takes out, and where a statement says so; None for none."""
    match change:
        case Remove() | Rename():
            return change.name, change.span
        case Update() if change.name != change.endpoint.name:
            return change.name, change.span
    return None, None
