"""When the timers of a unit tick."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterable

from plastron_tui.model.endpoint_details import TimerDetails
from plastron_tui.model.source import EndpointKind

from .analysis import Analysis, Site
from .durations import seconds
from .holders import holder_of
from .scopes import Variable
from .serving_timers import serves


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


def recreated(analysis: Analysis, sites: Iterable[Site]) -> set[Site]:
    """Return the calls that create a timer again which another one creates.

    Such a call gives the variable that holds the timer another one with the same callback, as
    where a parameter changes how often it ticks. The call that says the period stands for them.
    """
    same: dict[tuple[Variable, str], list[Site]] = defaultdict(list)
    timers = [site for site in sites if site.endpoint.kind is EndpointKind.TIMER]
    for site in timers if len(timers) > 1 else ():
        held = holder_of(analysis, site)
        if held is not None and not (held.is_list or "map<" in held.type):
            same[held, site.endpoint.callback or _given(site)].append(site)
    found: set[Site] = set()
    for each in same.values():
        says = (site for site in each if timer_details(analysis, site).period is not None)
        kept = next(says, each[0])
        found.update(site for site in each if site is not kept)
    return found


def _given(site: Site) -> str:
    """Return the text of what a timer calls."""
    at = site.shape.callback
    is_said = at is not None and at < len(site.arguments)
    text = site.file.syntax.slice(site.arguments[at]) if is_said and at is not None else ""
    return "".join(text.split())


def _is_oneshot(analysis: Analysis, site: Site) -> bool:
    """Whether `createTimer(period, callback, [object,] oneshot)` says that it ticks once."""
    for given in site.arguments[2:4]:
        value = analysis.evaluator.fold(given, site.place)
        if value is not None and isinstance(value.value, bool):
            return value.value
    return False
