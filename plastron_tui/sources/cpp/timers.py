"""When the timers of a unit tick."""

from __future__ import annotations

import math

from plastron_tui.model.endpoint_details import TimerDetails

from .analysis import Analysis, Site
from .durations import seconds
from .serving import serves


def timer_details(analysis: Analysis, site: Site) -> TimerDetails:
    """Return when the timer of a call site ticks."""
    given = site.arguments
    at = site.shape.name
    period = seconds(analysis, given[at], site.place, 0) if at < len(given) else None
    number = period.number if period is not None else None
    is_known = number is not None and math.isfinite(number) and number >= 0
    is_guess = period is not None and (period.is_guess or period.is_default)
    return TimerDetails(
        period=float(number) if is_known and number is not None else None,
        is_oneshot=analysis.ros_version == 1 and _is_oneshot(analysis, site),
        is_guess=is_known and is_guess,
        serves=serves(analysis, site),
    )


def _is_oneshot(analysis: Analysis, site: Site) -> bool:
    """Whether `createTimer(period, callback, [object,] oneshot)` says that it ticks once."""
    for given in site.arguments[2:4]:
        value = analysis.evaluator.fold(given, site.place)
        if value is not None and isinstance(value.value, bool):
            return value.value
    return False
