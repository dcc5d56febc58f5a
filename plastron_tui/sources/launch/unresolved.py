"""What a launch file leaves open, as diagnostics."""

from __future__ import annotations

from pathlib import Path

from plastron_tui.diagnostics import Diagnostic, Severity, Span, codes
from plastron_tui.ros.launch_resolution import Resolved


def warnings_of(resolved: Resolved) -> tuple[Diagnostic, ...]:
    """Return a warning for each thing that is left out, since it is not known."""
    return tuple(
        Diagnostic(
            codes.UNRESOLVED_LAUNCH,
            each.message,
            None if each.place is None else Span(each.place.start, each.place.end),
            None if each.file is None else Path(each.file),
            severity=Severity.WARNING,
        )
        for each in resolved.unresolved
    )
