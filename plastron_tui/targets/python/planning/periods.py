"""How often a file does something."""

from __future__ import annotations

from plastron_tui.model.kinds import Rate
from plastron_tui.sources.python import literals

from ..plan import TimerPlan
from .writing import Writing


def planned_timer(writing: Writing, rate: Rate, method: str, attribute: str) -> TimerPlan:
    """Plan what calls a method at a rate; with an attribute where the rate or the timer may end."""
    if rate.parameter is None:
        hertz = rate.hertz
        number = literals.number(int(hertz) if hertz.is_integer() else hertz)
        return TimerPlan(method, f"1 / {number}", attribute=writing.held(attribute))
    value = writing.parameter(rate.parameter)
    if writing.is_rclpy:
        writing.imports.use("rcl_interfaces.msg", "SetParametersResult")
    name = rate.parameter.removeprefix("~/")
    return TimerPlan(
        method,
        f"1 / {value}",
        attribute=writing.attributes.new(attribute),
        parameter=literals.string(name),
        rate=value,
    )
