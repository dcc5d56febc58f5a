"""What a launch file leaves open, as diagnostics."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path

from plastron_tui.diagnostics import Diagnostic, Severity, Span, codes, did_you_mean
from plastron_tui.ros.launch import Argument, LaunchFile, items_of
from plastron_tui.ros.launch_started import Resolved


def warnings_of(resolved: Resolved) -> tuple[Diagnostic, ...]:
    """Return a warning for each thing that is left out, and an error for what cannot be started."""
    return tuple(
        Diagnostic(
            codes.UNRESOLVED_LAUNCH,
            each.message,
            None if each.place is None else Span(each.place.start, each.place.end),
            None if each.file is None else Path(each.file),
            severity=Severity.ERROR if each.is_wrong else Severity.WARNING,
        )
        for each in resolved.unresolved
    )


def wrong_arguments(
    launch: LaunchFile, file: Path, given: Mapping[str, str]
) -> Iterator[Diagnostic]:
    """Yield what is wrong with the arguments that a launch file is given."""
    declared = list(items_of(launch.items, Argument))
    for each in declared:
        if each.default is None and each.condition is None and each.name not in given:
            place = each.place
            yield Diagnostic(
                codes.UNRESOLVED_LAUNCH,
                f"the argument `{each.name}` has no value",
                None if place is None else Span(place.start, place.end),
                file,
                help=f"give it one: `{each.name}:=VALUE`",
            )
    names = {each.name for each in declared}
    for name in given:
        if name not in names:
            yield Diagnostic(
                codes.UNRESOLVED_LAUNCH,
                f"the launch file has no argument `{name}`",
                help=did_you_mean(name, names),
                severity=Severity.WARNING,
            )
