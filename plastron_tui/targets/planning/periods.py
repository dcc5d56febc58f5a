"""How often a file does something."""

from __future__ import annotations

from plastron_tui.model.kinds import Rate

from .plan import TimerPlan
from .writing import Writing


def planned_timer(writing: Writing, rate: Rate, method: str, attribute: str) -> TimerPlan:
    """Plan what calls a method at a rate; with an attribute where the rate or the timer may end."""
    if rate.parameter is None:
        return TimerPlan(method, writing.period(rate.hertz), attribute=writing.held(attribute))
    value = writing.parameter(rate.parameter)
    writing.follow_rate()
    return TimerPlan(
        method,
        writing.period(value),
        attribute=writing.attributes.new(attribute),
        parameter=writing.string(rate.parameter.removeprefix("~/")),
        rate=value,
    )
